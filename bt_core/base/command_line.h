// The arguments of a program or of a verb, taken apart: files, and options with one value each.
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
  std::map<std::string, std::string> values;  ///< "--ticks" -> "5"; a flag has an empty value

  bool Has(const std::string& name) const { return values.count(name) > 0; }
  std::string Get(const std::string& name, const std::string& otherwise = {}) const;
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
