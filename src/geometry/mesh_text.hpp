// The lines of a mesh as text: Abaqus' keywords with their data, or plain rows of numbers.
#pragma once
#include <string>
#include <vector>

namespace swarf {

struct MeshRow {
  int line = 0;                    // of the file
  std::vector<std::string> fields; // between commas, without blanks around them
};

// "*NSET, NSET=left, GENERATE": name "NSET", options {"NSET=left", "GENERATE"}, and the rows up to the next
// one.
struct MeshKeyword {
  int line = 0;
  std::string name;
  std::vector<std::string> options;
  std::vector<MeshRow> rows;
  std::string option(const std::string& key) const; // "left" for "nset"; "" if it is not there
  bool has(const std::string& key) const;
};

std::string upper(std::string text);

// Rows before the first keyword are of one without a name. "**" and "#" begin a line of comment; a row that
// ends with a comma goes on in the next line.
std::vector<MeshKeyword> read_mesh_text(const std::string& text);

// Throws DeckError "FILE:LINE: ...".
double number_in(const MeshRow& row, std::size_t field, const std::string& file);
long label_in(const MeshRow& row, std::size_t field, const std::string& file); // a whole number from 1 on
[[noreturn]] void refuse_line(const std::string& file, int line, const std::string& what);

} // namespace swarf
