// The arguments of a program or of a verb, taken apart: files, and options with a value each.
#ifndef COPPICE_BT_CORE_BASE_COMMAND_LINE_H_
#define COPPICE_BT_CORE_BASE_COMMAND_LINE_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace coppice {

struct Options {
  std::vector<std::string> files;
  /// "--ticks" -> {"5"}, one for each time it is given; a flag has an empty value.
  std::map<std::string, std::vector<std::string>> values;

  bool Has(const std::string& name) const { return values.count(name) > 0; }
  /// The last value given.
  std::string Get(const std::string& name, const std::string& otherwise = {}) const;
  std::vector<std::string> GetAll(const std::string& name) const;
  /// A whole number, or nothing if the option is missing or no number.
  std::optional<std::int64_t> GetNumber(const std::string& name) const;
};

/// `with_value` and `flags` name the options that there are. Prints the usage and returns nothing
/// if there is an unknown option or a value is missing.
std::optional<Options> ParseOptions(const std::vector<std::string>& arguments,
                                    const std::vector<std::string>& with_value,
                                    const std::vector<std::string>& flags,
                                    const std::string& usage);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_COMMAND_LINE_H_
