// What the short names and marks of a table mean.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace etalon::table {

/// Longest line of a table, in columns of the terminal, that is not asked to be wide.
inline constexpr std::size_t line_width = 100;

/// Returns "contra-" and "dicted" as one word, other names with a blank between them.
std::string whole_name(const std::string& above, const std::string& name);

class Legend {
  public:
    /// Adds an entry, unless there is the same already or its meaning is empty.
    void add(const std::string& name, const std::string& meaning);

    /// Returns a line for each entry, wrapped at words to `line_width`.
    std::string text() const;

  private:
    std::vector<std::pair<std::string, std::string>> entries_;
};

}  // namespace etalon::table
