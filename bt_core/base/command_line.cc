#include "bt_core/base/command_line.h"

#include <algorithm>
#include <charconv>
#include <iostream>

#include "bt_core/base/diagnostic.h"

namespace coppice {

std::string Options::Get(const std::string& name, const std::string& otherwise) const {
  const auto found = values.find(name);
  return found == values.end() ? otherwise : found->second.back();
}

std::vector<std::string> Options::GetAll(const std::string& name) const {
  const auto found = values.find(name);
  return found == values.end() ? std::vector<std::string>() : found->second;
}

std::optional<std::int64_t> Options::GetNumber(const std::string& name) const {
  const std::string text = Get(name);
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::optional<Options> ParseOptions(const std::vector<std::string>& arguments,
                                    const std::vector<std::string>& with_value,
                                    const std::vector<std::string>& flags,
                                    const std::string& usage) {
  const auto contains = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument.size() < 2 || argument.front() != '-') {
      options.files.push_back(argument);
    } else if (contains(flags, argument)) {
      options.values[argument].emplace_back();
    } else if (contains(with_value, argument) && i + 1 < arguments.size()) {
      options.values[argument].push_back(arguments[++i]);
    } else if (argument == "--help" || argument == "-h") {
      std::cout << "usage: " << usage << "\n";
      return std::nullopt;
    } else {
      std::vector<std::string> all = with_value;
      all.insert(all.end(), flags.begin(), flags.end());
      const bool known = contains(with_value, argument);
      std::cerr << (known ? argument + " needs a value" : "unknown option " + argument + " ")
                << (known ? "" : DidYouMean(argument, all)) << "\nusage: " << usage << "\n";
      return std::nullopt;
    }
  }
  return options;
}

}  // namespace coppice
