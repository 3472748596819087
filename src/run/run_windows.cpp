#include "src/run/run_windows.hpp"
#include "src/accuracy/accuracy.hpp"
#include "src/files/folder_lock.hpp"
#include "src/files/say.hpp"
#include "src/mechanistic/model.hpp"
#include "src/pictures/pictures.hpp"
#include "src/plots/plot.hpp"
#include "src/run/child_process.hpp"
#include "src/windows/join_windows.hpp"
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <deque>
#include <fmt/format.h>
#include <map>
#include <numbers>

namespace swarf {
namespace fs = std::filesystem;
namespace {

std::string text_of(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) ? read_text(file) : "";
}

// The value behind "key": in a JSON text that write_summary wrote; "" if there is none.
std::string value_in(const std::string& json, const std::string& key) {
  const auto at = json.find("\"" + key + "\": ");
  if (at == json.npos) return "";
  const auto begin = at + key.size() + 4;
  return json.substr(begin, json.find_first_of(",\n", begin) - begin);
}

// One window's files: its folder NAME, and NAME.toml, NAME.log, NAME.core_seconds beside.
struct WindowFiles {
  fs::path stem;

  ResultsFolder results() const { return {stem}; }
  fs::path file(const std::string& extension) const { return stem.string() + extension; }

  bool is_of(const Deck& deck) const { return text_of(results().deck()) == resolved_deck(deck); }
  bool is_complete(const Deck& deck) const {
    const std::string summary = text_of(results().summary());
    const double time = std::strtod(value_in(summary, "time").c_str(), nullptr); // --stop-after ends early
    return is_of(deck) && value_in(summary, "ended") == "\"complete\"" &&
           time >= end_time_of(deck) * (1 - 1e-9);
  }
  bool has_checkpoint(const Deck& deck) const {
    return is_of(deck) && fs::exists(results().checkpoint()) && fs::exists(results().history());
  }
  double core_seconds() const {
    const std::string text = text_of(file(".core_seconds"));
    return std::strtod(text.c_str(), nullptr);
  }
  std::string last_words() const { // of its log, which shows progress before
    const std::string log = text_of(file(".log"));
    const auto at = log.rfind("swarf: ");
    return at == log.npos ? "" : log.substr(at + 7, log.find('\n', at) - at - 7);
  }
};

class WindowsRun {
 public:
  WindowsRun(const RunOptions& from, const WindowsOptions& as, const Deck& deck)
      : options(from), how(as),
        whole(deck), folder{options.output.empty() ? default_output(options.deck) : options.output} {
    for (const Window& window : cut_windows(whole, *whole.windows))
      results.push_back({window, "not run", 0, {}});
  }

  int run() {
    check_inputs();
    const FolderLock lock(folder.path);
    check_windows();
    write_file(folder.deck(), resolved_deck(whole));
    const auto begin = std::chrono::steady_clock::now();
    run_all();
    measure();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    write_windows(folder, whole, results, wall.count());
    if (whole.mechanistic)
      write_table(run_model(whole, *whole.mechanistic), ResultsFolder{folder.path}.mechanistic());
    report();
    if (options.pictures && !interrupted) draw_windows(folder.path);
    if (interrupted) return 130;
    for (const WindowResult& r : results)
      if (!r.is_complete()) return 3;
    return 0;
  }

 private:
  RunOptions options;
  WindowsOptions how;
  Deck whole;
  PassFolder folder;
  std::vector<WindowResult> results;
  bool interrupted = false;

  WindowFiles files(const WindowResult& r) const { return {folder.path / r.window.name}; }
  double degrees(const WindowResult& r) const { return r.window.centre * 180 / std::numbers::pi; }

  // Nothing that the user wrote is written over.
  void check_inputs() const {
    std::vector<fs::path> ours{folder.deck(), folder.table(), folder.summary(), folder.picture()};
    for (const WindowResult& r : results)
      ours.push_back(files(r).file(".toml")), ours.push_back(files(r).file(".log"));
    for (const fs::path& file : ours)
      if (is_same_file(file, options.deck))
        throw ResultsError(
            fmt::format("{}: the results would be written over this deck; choose another folder with "
                        "--output",
                        file.string()));
    std::error_code ignored;
    for (const fs::path& file : ours)
      if (fs::exists(file, ignored) && !fs::exists(folder.deck(), ignored))
        throw ResultsError(
            fmt::format("{}: is in the way: nothing says that swarf wrote it (no windows.toml beside "
                        "it); move it, or choose another folder with --output",
                        file.string()));
    if (fs::exists(folder.deck(), ignored) && !is_resolved_deck(folder.deck()))
      throw ResultsError(
          fmt::format("{}: is in the way: swarf did not write it; move it, or choose another folder with "
                      "--output",
                      folder.deck().string()));
  }

  // Windows that are complete stay. What is unfinished, or of another deck, is lost only if asked for.
  void check_windows() const {
    for (const WindowResult& r : results) {
      const WindowFiles f = files(r);
      std::error_code ignored;
      if (options.overwrite || f.is_complete(r.window.deck) || !fs::exists(f.results().history(), ignored))
        continue;
      const bool other = !f.is_of(r.window.deck);
      if (!other && options.resume) continue;
      throw ResultsError(
          fmt::format("{}: holds {}; {}replace it with --overwrite, or choose another folder with "
                      "--output",
                      f.stem.string(), other ? "a window of another deck" : "an unfinished window",
                      other ? "" : "go on from its checkpoint with --resume, "));
    }
  }

  void run_all() {
    // Several processes of one thread each would all be bound to the first core.
    if (how.jobs > 1) setenv("OMP_PROC_BIND", "false", 1);
    ChildProcesses children;
    std::map<pid_t, WindowResult*> running;
    std::deque<WindowResult*> waiting;
    for (WindowResult& r : results) {
      r.core_seconds = files(r).core_seconds();
      if (files(r).is_complete(r.window.deck))
        r.ended = "complete", say("window {:.6g} deg: complete already\n", degrees(r));
      else
        waiting.push_back(&r);
    }
    while (!running.empty() || (!waiting.empty() && !children.interrupted())) {
      while (!waiting.empty() && int(running.size()) < how.jobs && !children.interrupted()) {
        WindowResult& r = *waiting.front();
        waiting.pop_front();
        running[start(r, children)] = &r;
      }
      const EndedChild ended = children.wait();
      if (ended.pid < 0) break;
      const auto row = running.find(ended.pid);
      if (row == running.end()) continue;
      finish(*row->second, ended);
      running.erase(row);
    }
    interrupted = children.interrupted();
  }

  pid_t start(WindowResult& r, ChildProcesses& children) const {
    const bool resume = options.resume && files(r).has_checkpoint(r.window.deck);
    if (!resume) r.core_seconds = 0;
    const std::string deck = files(r).file(".toml").string();
    write_file(deck, resolved_deck(r.window.deck));
    std::vector<std::string> arguments{"run", deck, "--output", files(r).stem.string(), "--no-pictures"};
    const int threads = how.threads > 0 ? how.threads : how.jobs > 1 ? 1 : 0;
    if (threads > 0) arguments.insert(arguments.end(), {"--threads", std::to_string(threads)});
    arguments.push_back(resume ? "--resume" : "--overwrite"); // as check_windows has found right
    say("window {:.6g} deg: {}, see {}\n", degrees(r), resume ? "goes on" : "starts",
        files(r).file(".log").string());
    return children.start(arguments, files(r).file(".log"), resume);
  }

  void finish(WindowResult& r, const EndedChild& child) const {
    r.core_seconds += child.core_seconds;
    write_file(files(r).file(".core_seconds"), fmt::format("{}\n", r.core_seconds));
    const bool by_signal =
        child.status == 130 || child.status == 128 + SIGINT || child.status == 128 + SIGTERM;
    if (child.status == 0 && files(r).is_complete(r.window.deck))
      r.ended = "complete";
    else if (by_signal)
      r.ended = "interrupted";
    else
      r.ended = fmt::format("failed with exit status {}: {}", child.status, files(r).last_words());
    say("window {:.6g} deg: {} ({:.1f} core-seconds)\n", degrees(r), r.ended, r.core_seconds);
  }

  void measure() {
    constexpr double per_degree = 180 / std::numbers::pi;
    for (WindowResult& r : results) {
      if (!r.is_complete()) continue;
      try {
        r.force = measure_force(read_history(files(r).results().history()), r.window.from * per_degree,
                                r.window.to * per_degree);
      } catch (const ResultsError& error) {
        r.ended = fmt::format("not measured: {}", error.what());
      }
    }
  }

  void report() const {
    double core_seconds = 0;
    std::string unfinished;
    std::vector<double> immersion, force;
    say("\nimmersion [deg]  uncut chip [um]  planar force [N]      F_x       F_y       F_z  core-seconds\n");
    for (const WindowResult& r : results) {
      core_seconds += r.core_seconds;
      const auto& m = r.force.mean;
      if (r.is_complete()) immersion.push_back(degrees(r)), force.push_back(m[3]);
      if (r.is_complete())
        say("{:15.6g}  {:15.2f}  {:8.3f} +- {:.3f}  {:8.3f}  {:8.3f}  {:8.3f}  {:12.1f}\n", degrees(r),
            1e6 * r.window.uncut_chip, m[3], r.force.error[3], m[0], m[1], m[2], r.core_seconds);
      else
        unfinished += fmt::format("  {:.6g} deg: {}\n", degrees(r), r.ended);
    }
    if (const double scatter = scatter_between(immersion, force); !std::isnan(scatter))
      say("windows scatter by {:.3f} N about a sine: an error of each besides its own\n", scatter);
    say("{:.0f} core-seconds; the whole pass is predicted to take {}{:.0f}\nresults: {}\n", core_seconds,
        whole.sleep.distance ? "at most, for more of it freezes, " : "", predict_whole_pass(whole, results),
        folder.table().string());
    if (unfinished.empty()) return;
    complain("these windows are missing; run the same command again, with --resume to go on "
             "from checkpoints, --overwrite to start them anew:\n{}",
             unfinished);
  }
};

} // namespace

int run_windows(const Deck& deck, const RunOptions& options, const WindowsOptions& how) {
  say("{}", show_pick(deck));
  if (options.stop_after > 0)
    throw DeckError(
        "--stop-after does not go with windows: each must reach its end to be measured. Leave one out.");
  return WindowsRun(options, how, deck).run();
}

} // namespace swarf
