#include "bt_core/base/command_line.h"

#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <sstream>
#include <utility>

#include "bt_core/base/diagnostic.h"

namespace coppice {
namespace {

using Kind = CommandOption::Kind;

constexpr std::size_t kLineLength = 100;
constexpr std::size_t kWidestNames = 32;

std::optional<std::int64_t> ReadWhole(const std::string& text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// strtod, because GCC 9 has no from_chars for it.
std::optional<double> ReadReal(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return text.empty() || *end != '\0' ? std::nullopt : std::optional(number);
}

std::string Joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

std::string NumberText(double number) {
  char text[40];
  std::snprintf(text, sizeof(text), "%.12g", number);
  return text;
}

std::string Limits(const CommandOption& option) {
  return NumberText(option.low) + " to " + NumberText(option.high);
}

bool IsWithin(const CommandOption& option, double number) {
  return number >= option.low && number <= option.high;
}

// What was expected; empty if this is it.
std::string ExpectedBy(const CommandOption& option, const std::string& text) {
  if (option.kind == Kind::kWhole) {
    const auto number = ReadWhole(text);
    if (!number || !IsWithin(option, static_cast<double>(*number))) {
      return "expected a whole number from " + Limits(option);
    }
  } else if (option.kind == Kind::kReal) {
    const auto number = ReadReal(text);
    if (!number || !IsWithin(option, *number)) return "expected a number from " + Limits(option);
  } else if (option.kind == Kind::kChoice) {
    const auto& choices = option.choices;
    if (std::find(choices.begin(), choices.end(), text) == choices.end()) {
      return "expected one of " + Joined(choices, ", ");
    }
  }
  return "";
}

std::string Wrapped(const std::string& text, std::size_t width) {
  std::string wrapped;
  std::size_t column = 0;
  std::istringstream words(text);
  for (std::string word; words >> word; column += word.size()) {
    const bool fits = column + 1 + word.size() <= width;
    if (column > 0) wrapped += fits ? " " : "\n";
    column = fits && column > 0 ? column + 1 : 0;
    wrapped += word;
  }
  return wrapped;
}

class HelpFormatter : public CLI::Formatter {
 public:
  explicit HelpFormatter(const Command& command) : command_(command) {
    std::size_t width = 0;
    for (const CommandOption& option : command.options) width = std::max(width, WidthOf(option));
    width_ = std::min(width + 4, kWidestNames);
    column_width(width_);
    label("REQUIRED", "");
  }
  std::size_t help_width() const { return kLineLength - width_; }

  std::string make_usage(const CLI::App*, std::string) const override {
    const std::string& files = command_.files.text;
    return "usage: " + command_.name + " [options]" + (files.empty() ? "" : " " + files) + "\n" +
           (command_.text.empty() ? "" : "\n" + command_.text + "\n");
  }
  std::string make_positionals(const CLI::App*) const override { return ""; }
  std::string make_option_opts(const CLI::Option* option) const override {
    return option->get_type_name().empty() ? "" : " " + option->get_type_name();
  }

 private:
  static std::size_t WidthOf(const CommandOption& option) {
    return option.name.size() + 1 + option.value.size();
  }

  const Command& command_;
  std::size_t width_ = 0;
};

// CLI11's view of a command.
class Parser {
 public:
  explicit Parser(const Command& command) : command_(command), app_("", command.name) {
    const auto formatter = std::make_shared<HelpFormatter>(command);
    app_.formatter(formatter);
    app_.set_help_flag("-h,--help", "prints this");
    app_.allow_extras();
    for (const CommandOption& option : command.options) Add(option, formatter->help_width());
  }

  std::string Help() const { return app_.help(); }

  Options Parse(std::vector<std::string> arguments) {
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
    std::string problem;
    try {
      app_.parse(std::move(arguments));
    } catch (const CLI::CallForHelp&) {
      std::cout << Help();
      return Ended(FinishOutput(0));
    } catch (const CLI::ParseError& error) {
      problem = error.what();
    }
    Options options;
    const std::string unknown = TakeFiles(options.files);
    for (const auto& [name, option] : options_) options.values[name] = option->results();
    if (!unknown.empty()) problem = unknown;
    if (problem.empty()) problem = WrongNumber(options.files);
    return problem.empty() ? options : Ended(RefuseOptions(command_, problem));
  }

 private:
  static Options Ended(int status) {
    Options options;
    options.exit = status;
    return options;
  }

  void Add(const CommandOption& option, std::size_t width) {
    const std::string help = Wrapped(option.help, width);
    CLI::Option* added = nullptr;
    if (option.kind == Kind::kFlag) {
      added = app_.add_flag(option.name, help)->disable_flag_override();
    } else {
      added = app_.add_option(option.name, help)->type_name(option.value);
      added->expected(1, option.is_list ? 1 << 20 : 1)->take_all()->allow_extra_args(false);
      added->check([&option](const std::string& text) {
        const std::string expected = ExpectedBy(option, text);
        return expected.empty() ? "" : expected + ", not \"" + text + "\"";
      });
    }
    if (option.is_list) added->allow_extra_args();
    added->required(option.is_needed);
    options_[option.name] = added;
  }

  // What is left over are files, and options that there are not: the first of them is a problem.
  std::string TakeFiles(std::vector<std::string>& files) const {
    bool only_files = false;
    for (const std::string& argument : app_.remaining()) {
      if (argument == "--" && !only_files) {
        only_files = true;
      } else if (only_files || argument.size() < 2 || argument[0] != '-') {
        files.push_back(argument);
      } else {
        return Unknown(argument);
      }
    }
    return "";
  }

  std::string Unknown(const std::string& argument) const {
    std::vector<std::string> names;
    for (const CommandOption& option : command_.options) names.push_back(option.name);
    const std::string hint = DidYouMean(argument, names);
    return "unknown option " + argument + (hint.empty() ? "" : " (" + hint + ")");
  }

  std::string WrongNumber(const std::vector<std::string>& given) const {
    const CommandFiles& files = command_.files;
    if (given.size() < files.least) return "expected " + files.text;
    return given.size() > files.most ? "\"" + given[files.most] + "\" is one too many" : "";
  }

  const Command& command_;
  CLI::App app_;
  std::map<std::string, CLI::Option*> options_;
};

// Those that are closed: the first file of the program would be one of them otherwise, and what is
// printed would be written into it. What is taken cannot be written to, so FinishOutput still says
// that it was closed.
void TakeStandardDescriptors() {
  int taken = 0;
  do {
    taken = open("/dev/null", O_RDONLY);
  } while (taken >= 0 && taken <= STDERR_FILENO);
  if (taken > STDERR_FILENO) close(taken);
}

}  // namespace

CommandOption CommandOption::Flag(std::string name, std::string help) {
  CommandOption option;
  option.name = std::move(name);
  option.help = std::move(help);
  return option;
}

CommandOption CommandOption::Text(std::string name, std::string value, std::string help) {
  CommandOption option = Flag(std::move(name), std::move(help));
  option.kind = Kind::kText;
  option.value = std::move(value);
  return option;
}

CommandOption CommandOption::Whole(std::string name, std::string value, double low, double high,
                                   std::string help) {
  CommandOption option = Text(std::move(name), std::move(value), std::move(help));
  option.kind = Kind::kWhole;
  option.low = low;
  option.high = high;
  return option;
}

CommandOption CommandOption::Real(std::string name, std::string value, double low, double high,
                                  std::string help) {
  CommandOption option = Whole(std::move(name), std::move(value), low, high, std::move(help));
  option.kind = Kind::kReal;
  return option;
}

CommandOption CommandOption::OneOf(std::string name, std::vector<std::string> choices,
                                   std::string help) {
  CommandOption option = Text(std::move(name), Joined(choices, "|"), std::move(help));
  option.kind = Kind::kChoice;
  option.choices = std::move(choices);
  return option;
}

CommandOption CommandOption::Needed() && {
  is_needed = true;
  return std::move(*this);
}

CommandOption CommandOption::List() && {
  is_list = true;
  return std::move(*this);
}

std::string Options::Get(const std::string& name, const std::string& otherwise) const {
  const std::vector<std::string>& all = values.at(name);
  return all.empty() ? otherwise : all.back();
}

std::int64_t Options::Whole(const std::string& name, std::int64_t otherwise) const {
  return ReadWhole(Get(name)).value_or(otherwise);
}

double Options::Real(const std::string& name, double otherwise) const {
  return ReadReal(Get(name)).value_or(otherwise);
}

std::vector<CommandOption> Together(std::vector<CommandOption> options,
                                    const std::vector<CommandOption>& shared) {
  options.insert(options.end(), shared.begin(), shared.end());
  return options;
}

Options ParseOptions(const Command& command, const std::vector<std::string>& arguments) {
  TakeStandardDescriptors();
  return Parser(command).Parse(arguments);
}

int RefuseOptions(const Command& command, const std::string& problem) {
  std::cerr << command.name << ": " << problem << "; see " << command.name << " --help\n";
  return 2;
}

std::string HelpText(const Command& command) { return Parser(command).Help(); }

int FinishOutput(int status) {
  std::cout.flush();
  if (std::cout && std::fflush(stdout) == 0) return status;
  std::cerr << "the standard output cannot be written\n";
  return 2;
}

}  // namespace coppice
