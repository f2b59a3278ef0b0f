// Meanings of the short names and marks of a table.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace etalon::table {

/// Longest line of a narrow table, in columns of the terminal.
inline constexpr std::size_t line_width = 100;

/// Joins the two parts of a name: "contra-" and "dicted" to one word, others with a blank.
std::string whole_name(const std::string& above, const std::string& name);

class Legend {
  public:
    /// Adds an entry, unless it exists already or its meaning is empty.
    void add(const std::string& name, const std::string& meaning);

    /// Returns a line for each entry, wrapped at words to `line_width`.
    std::string text() const;

  private:
    std::vector<std::pair<std::string, std::string>> entries_;
};

}  // namespace etalon::table
