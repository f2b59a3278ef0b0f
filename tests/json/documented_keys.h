// What docs/json.md says of a JSON, as patterns that its values match.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace etalon::test {

/// The way to a value: keys, and "[]" for the entries of a list. In a pattern "<name>" stands for
/// any key of its kind.
using Path = std::vector<std::string>;

/// A kind of value at a place, as one line of the document has it.
struct Pattern {
    Path path;
    std::string type;  ///< "integer", "number", "string", "boolean", "null", "object"
    std::string line;  ///< where it is said, and for which of the types: equal for what is shared
};

struct DocumentedSection {
    struct Row {
        std::string key, type;
    };
    std::vector<std::string> includes;  ///< names of the sections whose keys it has, too
    std::vector<Row> rows;
};

/// By the anchors of their headings. Throws std::runtime_error where a row is not understood.
using DocumentedSections = std::map<std::string, DocumentedSection>;
DocumentedSections read_sections(const std::string& markdown);

/// All that a section says, what it links to included.
std::vector<Pattern> patterns_of(const DocumentedSections& sections, const std::string& section);

}  // namespace etalon::test
