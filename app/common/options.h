// Declaring the options of a command. CLI11 does the work, out of sight: it is several thousand
// lines of templates, and each file that includes it takes ten seconds longer to compile.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/common/value_choices.h"

namespace CLI {
class App;
}

namespace etalon {

/// An option just declared. Each function adds a rule to it and returns it, for the next one.
class Option {
  public:
    Option(CLI::Option& option, ValueChoices& choices) : option_(&option), choices_(&choices) {}

    /// Name of the value in the help: FILE, SECONDS (default: N for whole numbers, X for others,
    /// NAME for text).
    Option& value(const std::string& name);
    Option& required();
    /// Lets the value be left out; it is then `usual`. What follows is taken for the value, unless
    /// it is an option or the last positional argument.
    Option& value_or(const std::string& usual);
    /// Several values, with commas between them.
    Option& by_commas();
    /// Lets the option be repeated, with one value each time.
    Option& one_value_each();
    Option& excludes(const std::string& other);
    /// Shows in the help the value that the variable has now.
    Option& show_default();
    /// The heading in the help below which it stands.
    Option& group(const std::string& heading);

    /// Offers values where a command line is completed.
    Option& suggest(const std::vector<std::string>& values);
    /// Allows these values alone. The help names them, and the ranges below.
    Option& one_of(const std::vector<std::string>& values);
    Option& within(int least, int most);
    Option& within(std::size_t least, std::size_t most);
    Option& within(double least, double most);
    Option& positive();
    Option& not_negative();
    /// `find_fault` returns a text without a fault empty, and else what is wrong with it, beginning
    /// with the text: "magic: expected one of ...".
    Option& check(std::function<std::string(const std::string&)> find_fault);

  private:
    /// Adds a sentence to the help: what the values may be.
    Option& explain(const std::string& rule);
    template <class T>
    Option& within_range(T least, T most);
    /// Checks a number by this alone.
    Option& narrow(std::function<std::string(const std::string&)> find_fault);

    CLI::Option* option_;
    ValueChoices* choices_;
};

/// The options of one command.
class Options {
  public:
    /// Records in `choices` the values that options take.
    Options(CLI::App& app, ValueChoices& choices) : app_(app), choices_(choices) {}

    /// Declares an option by its names, "-o,--output", or a positional argument by its bare name.
    /// Parsing writes to `value`, which must live until then: an integer, double or std::string, a
    /// vector of int or std::string, or an optional integer.
    template <class T>
    Option add(const std::string& names, T& value, const std::string& help);

    Option add_flag(const std::string& names, bool& value, const std::string& help);

    /// Adds text to the end of the help, as it is.
    void add_notes(const std::string& text);

  private:
    CLI::App& app_;
    ValueChoices& choices_;
};

}  // namespace etalon
