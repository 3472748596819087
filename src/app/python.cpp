#include "src/app/python.hpp"
#include "src/files/say.hpp"
#include <cstdlib>
#include <filesystem>
#include <sys/wait.h>
#include <unistd.h>

namespace swarf {
namespace fs = std::filesystem;
namespace {

// Beside an installed program, or of the sources that this one was built from.
std::string find_package(const fs::path& program) {
  const fs::path installed = program.parent_path().parent_path() / "share" / "swarf" / "python";
  std::error_code ignored;
  return fs::exists(installed / "swarf" / "__main__.py", ignored) ? installed.string() : SWARF_PYTHON_PACKAGE;
}

bool has_packages(const std::string& python) {
  const std::string look =
      python + " -c 'import h5py, matplotlib, numpy, scipy, tomli_w, tomllib' >/dev/null 2>&1";
  return std::system(look.c_str()) == 0;
}

} // namespace

int run_python(const std::string& command, std::vector<std::string> arguments) {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const char* given = std::getenv("PYTHONPATH");
  setenv("PYTHONPATH", (find_package(program) + (given && *given ? std::string(":") + given : "")).c_str(),
         1);
  setenv("SWARF_PROGRAM", program.c_str(), 0);                       // that the package runs decks with
  for (const std::string python : {"python3", "/usr/bin/python3"}) { // Debian's sees Debian's packages only
    if (!has_packages(python)) continue;
    std::vector<std::string> words{python, "-m", "swarf", command};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    execvp(pointers[0], pointers.data());
  }
  complain("{}: needs Python 3.11 with numpy, scipy, matplotlib, h5py and tomli_w; install them (Debian: "
           "python3-scipy python3-matplotlib python3-h5py python3-tomli-w)",
           command);
  return 1;
}

} // namespace swarf
