// Declaration of the options of a command. CLI11 is hidden behind it: it is several thousand lines
// of templates, and each file that includes it takes ten seconds longer to compile.
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "app/common/value_choices.h"

namespace CLI {
class App;
}

namespace etalon {

/// What is to be done once a command line is parsed.
using ParsedTasks = std::vector<std::function<void()>>;

/// The variable of an option that takes several values.
using ValueList = std::variant<std::monostate, std::vector<int>*, std::vector<std::string>*>;

/// An option that was just declared. Each function adds a rule to it and returns it, for chaining.
class Option {
  public:
    Option(CLI::Option& option, ValueChoices& choices, ParsedTasks& when_parsed, ValueList list)
        : option_(&option), choices_(&choices), when_parsed_(&when_parsed), list_(list) {}

    /// Sets the name of the value in the help: FILE, SECONDS (default: N for integers, X for other
    /// numbers, NAME for text).
    Option& value(const std::string& name);
    Option& required();
    /// Makes the value optional; `usual` replaces it. The next word is taken as the value, unless
    /// it is an option or the last positional argument.
    Option& value_or(const std::string& usual);
    /// Takes several values, separated by commas, each once.
    Option& by_commas();
    /// Takes the words of several values that may have commas in them, for joined_words().
    Option& words_by_commas();
    /// Takes a value once that is given several times.
    Option& each_once();
    /// Allows the option to be repeated, with one value each time.
    Option& one_value_each();
    Option& excludes(const std::string& other);
    /// Shows the current value of the variable in the help.
    Option& show_default();
    /// Sets the heading of the help under which it is listed.
    Option& group(const std::string& heading);

    /// Offers values for the completion of command lines.
    Option& suggest(const std::vector<std::string>& values);
    /// Allows only these values. The help names them, and the ranges below.
    Option& one_of(const std::vector<std::string>& values);
    Option& within(int least, int most);
    Option& within(std::size_t least, std::size_t most);
    Option& within(double least, double most);
    Option& positive();
    Option& not_negative();
    /// Checks a text by `find_error`, which returns an empty string for a valid text, else the
    /// error, beginning with the text: "magic: expected one of ...".
    Option& check(std::function<std::string(const std::string&)> find_error);

  private:
    /// Adds a sentence to the help: the allowed values.
    Option& explain(const std::string& rule);
    template <class T>
    Option& within_range(T least, T most);
    /// Checks a number only by this.
    Option& narrow(std::function<std::string(const std::string&)> find_error);

    CLI::Option* option_;
    ValueChoices* choices_;
    ParsedTasks* when_parsed_;
    ValueList list_;
};

/// The options of one command.
class Options {
  public:
    /// Records in `choices` the values that options accept.
    Options(CLI::App& app, ValueChoices& choices) : app_(app), choices_(choices) {}

    /// Declares an option by its names, "-o,--output", or a positional argument by its bare name.
    /// Parsing writes to `value`, which must live until then: an integer, double or std::string, a
    /// vector of int or std::string, or an optional integer.
    template <class T>
    Option add(const std::string& names, T& value, const std::string& help);

    Option add_flag(const std::string& names, bool& value, const std::string& help);

    /// Adds text to the end of the help, unchanged.
    void add_notes(const std::string& text);

    /// Returns what is to be done once the command line is parsed, before the command runs.
    const ParsedTasks& when_parsed() const { return when_parsed_; }

  private:
    CLI::App& app_;
    ValueChoices& choices_;
    ParsedTasks when_parsed_;
};

}  // namespace etalon
