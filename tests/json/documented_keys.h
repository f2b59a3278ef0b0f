// The statements of docs/json.md about a JSON, as patterns for its values.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace etalon::test {

/// Path of a value: keys, and "[]" for the entries of a list. In a pattern "<name>" stands for any
/// key of its kind.
using Path = std::vector<std::string>;

/// A kind of value at a path, as one line of the document describes it.
struct Pattern {
    Path path;
    std::string type;  ///< "integer", "number", "string", "boolean", "null", "object"
    std::string line;  ///< its line and the index of the type: equal for shared descriptions
};

struct DocumentedSection {
    struct Row {
        std::string key, type;
    };
    std::vector<std::string> includes;  ///< names of the sections whose keys it also has
    std::vector<Row> rows;
};

/// Sections by the anchors of their headings. Reading throws std::runtime_error if a row is
/// malformed.
using DocumentedSections = std::map<std::string, DocumentedSection>;
DocumentedSections read_sections(const std::string& markdown);

/// Returns the patterns of a section, including those of linked sections.
std::vector<Pattern> patterns_of(const DocumentedSections& sections, const std::string& section);

}  // namespace etalon::test
