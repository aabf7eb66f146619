// The command line of a program or of a verb, said once: a table of its options is what is read,
// what --help prints and what the shell completes.
//
//   const Command kTrace{"coppice trace", "run a tree with scripted leaves", {"FILE", 1, 1},
//                        "Prints what each tick did, one JSON line per tick.",
//                        {CommandOption::Whole("--ticks", "N", 0, 1000, "how many; else 1"),
//                         CommandOption::Flag("--quiet", "the result only")}};
//   const Options options = ParseOptions(kTrace, arguments);
//   if (options.exit) return *options.exit;
//   Trace(options.files[0], options.Whole("--ticks", 1), options.Has("--quiet"));
#ifndef COPPICE_BT_CORE_BASE_COMMAND_LINE_H_
#define COPPICE_BT_CORE_BASE_COMMAND_LINE_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace coppice {

/// An option, and what may stand behind it.
struct CommandOption {
  enum class Kind : std::uint8_t { kFlag, kText, kWhole, kReal, kChoice };

  std::string name;   ///< "--ticks" or "-o"
  std::string value;  ///< what stands behind it, for the help: "N"; empty: a flag
  std::string help;
  Kind kind = Kind::kFlag;
  double low = 0, high = 0;          ///< of kWhole and kReal, both included
  std::vector<std::string> choices;  ///< of kChoice
  bool is_needed = false;
  bool is_list = false;  ///< takes all that stands behind it up to the next option

  static CommandOption Flag(std::string name, std::string help);
  static CommandOption Text(std::string name, std::string value, std::string help);
  /// A whole number.
  static CommandOption Whole(std::string name, std::string value, double low, double high,
                             std::string help);
  /// Any number.
  static CommandOption Real(std::string name, std::string value, double low, double high,
                            std::string help);
  static CommandOption OneOf(std::string name, std::vector<std::string> choices, std::string help);
  CommandOption Needed() &&;
  CommandOption List() &&;
};

/// What a program takes that is no option: files, as a rule.
struct CommandFiles {
  std::string text;  ///< for the help: "FILE..."
  std::size_t least = 0, most = 0;
};
inline constexpr std::size_t kAnyNumber = SIZE_MAX;

struct Command {
  std::string name;     ///< as people call it: "coppice trace"
  std::string summary;  ///< a few words, for a list of programs
  CommandFiles files;
  std::string text;  ///< lines for the help
  std::vector<CommandOption> options;
};

/// The options of one command alone and those that it shares with others.
std::vector<CommandOption> Together(std::vector<CommandOption> options,
                                    const std::vector<CommandOption>& shared);

/// Arguments that fit a command. To ask for an option that the command has not throws
/// std::out_of_range.
struct Options {
  /// If set, there is nothing to do but to end with it: the help was printed (0), or what is wrong,
  /// or it could not be printed (2).
  std::optional<int> exit;
  std::vector<std::string> files;
  /// "--ticks" -> {"5"}, one for each time it is given; a flag has an empty value.
  std::map<std::string, std::vector<std::string>> values;

  bool Has(const std::string& name) const { return !values.at(name).empty(); }
  /// The last value given.
  std::string Get(const std::string& name, const std::string& otherwise = {}) const;
  const std::vector<std::string>& GetAll(const std::string& name) const { return values.at(name); }
  /// Of an option of that kind: within its limits.
  std::int64_t Whole(const std::string& name, std::int64_t otherwise) const;
  double Real(const std::string& name, double otherwise) const;
};

/// Prints the help (to the standard output) or what is wrong (to the other one), with the nearest
/// name of an unknown option. To be called before files are opened: none of them becomes a standard
/// stream that was closed.
Options ParseOptions(const Command& command, const std::vector<std::string>& arguments);

/// The end of a command line that makes no sense although each of its parts does: says what is
/// wrong and where the help is, and returns 2.
int RefuseOptions(const Command& command, const std::string& problem);

/// What `--help` prints.
std::string HelpText(const Command& command);

/// The exit status of a program that has printed to the standard output: 2, with a message, if that
/// could not be written (a full disk), else `status`.
int FinishOutput(int status);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_COMMAND_LINE_H_
