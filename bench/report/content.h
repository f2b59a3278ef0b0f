// Contents of the report, before it is HTML.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace etalon::bench_report {

enum class Mark { none, good, bad };

struct Cell {
    std::string text;
    Mark mark = Mark::none;
};

struct Column {
    std::string name;
    bool is_number = true;  ///< aligned to the right
};

struct Table {
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows;
};

/// A bar of a bar chart with its texts.
struct Bar {
    std::string name;
    int colour;  ///< 1 to 7, of the style sheet of bench/plot
    double value, spread;
    std::string text;  ///< the value
    std::string comparison;
    Cell note;  ///< how reliable it is: the errors beside a speed
};

/// Bars with a common scale from 0, and the meaning of their numbers.
struct BarGroup {
    std::string title, value, comparison, note;
    std::vector<Bar> bars;
};

struct Bars {
    std::vector<BarGroup> groups;
};

struct Chart {
    std::string title, svg;
    std::vector<std::string> remarks{};  ///< sentences below it
};

struct KeyEntry {
    int colour;
    std::string text;
};

struct Charts {
    std::vector<Chart> charts;
    std::vector<KeyEntry> key{};
};

struct Image {
    std::string title, png;  ///< a whole file in memory
    int width, height;
};

struct Images {
    std::vector<Image> images;
};

struct Figure {
    std::string title, caption;
    std::string command;  ///< command that measures the same
    std::string date;     ///< when it was measured
    std::variant<Table, Bars, Charts, Images> content;
    bool folded = false;  ///< collapsed until a reader opens it
};

struct Section {
    std::string id, title;
    std::vector<std::string> prose;
    std::vector<Figure> figures;
};

/// A number at the beginning of the report.
struct KeyFigure {
    std::string value, name, note;
};

struct Page {
    std::string title, subtitle;
    std::string introduction;
    std::string missing;  ///< why it is not complete; empty if it is
    std::string warning;  ///< why its figures are doubtful; empty if they are not
    std::vector<KeyFigure> summary;
    std::vector<Section> sections;
    std::string command;
};

}  // namespace etalon::bench_report
