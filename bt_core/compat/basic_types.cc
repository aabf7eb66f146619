#include "behaviortree_cpp/basic_types.h"

#include <cxxabi.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>

#include "behaviortree_cpp/json_export.h"

namespace BT {

std::string demangle(const std::type_index& index) {
  if (index == typeid(std::string)) return "std::string";
  if (index == typeid(std::string_view)) return "std::string_view";
  if (index == typeid(std::chrono::seconds)) return "std::chrono::seconds";
  if (index == typeid(std::chrono::milliseconds)) return "std::chrono::milliseconds";
  if (index == typeid(std::chrono::microseconds)) return "std::chrono::microseconds";
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> name(
      abi::__cxa_demangle(index.name(), nullptr, nullptr, &status), &std::free);
  return status == 0 ? name.get() : index.name();
}

std::string demangle(const std::type_info& info) { return demangle(std::type_index(info)); }

bool StartWith(StringView text, StringView prefix) {
  return text.substr(0, prefix.size()) == prefix;
}
bool StartWith(StringView text, char prefix) { return !text.empty() && text.front() == prefix; }

std::vector<StringView> splitString(const StringView& text, char delimiter) {
  std::vector<StringView> parts;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find(delimiter, start), text.size());
    parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

// ---- From text.

namespace internal {

void ThrowNoConversion(const std::type_info& type) {
  throw LogicError("there is no BT::convertFromString() for the type ", demangle(type));
}

namespace {

template <class T>
T ReadInteger(StringView text) {
  T value = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc()) {
    throw RuntimeError("Can't convert string [", text, "] to integer");
  }
  return value;
}

template <class T>
T ReadSmall(StringView text) {
  const auto value = ReadInteger<std::int64_t>(text);
  if (value >= std::numeric_limits<T>::lowest() && value <= std::numeric_limits<T>::max()) {
    return static_cast<T>(value);
  }
  throw RuntimeError("Value out of bound when converting [", text, "] to integer");
}

template <class T>
T ReadWhole(StringView text) {
  if constexpr (sizeof(T) == sizeof(std::int64_t)) {
    return ReadInteger<T>(text);
  } else {
    return ReadSmall<T>(text);
  }
}

template <class T>
std::vector<T> ReadList(StringView text) {
  if (StartWith(text, "json:")) return nlohmann::json::parse(text.substr(5)).get<std::vector<T>>();
  std::vector<T> values;
  for (const StringView part : splitString(text, ';')) {
    values.push_back(convertFromString<T>(part));
  }
  return values;
}

}  // namespace
}  // namespace internal

template <>
std::string convertFromString<std::string>(StringView text) {
  return std::string(text);
}
template <>
const char* convertFromString<const char*>(StringView text) {
  return text.data();
}
#define COPPICE_READ_WHOLE(T)               \
  template <>                               \
  T convertFromString<T>(StringView text) { \
    return internal::ReadWhole<T>(text);    \
  }
COPPICE_READ_WHOLE(int8_t)
COPPICE_READ_WHOLE(int16_t)
COPPICE_READ_WHOLE(int32_t)
COPPICE_READ_WHOLE(int64_t)
COPPICE_READ_WHOLE(uint8_t)
COPPICE_READ_WHOLE(uint16_t)
COPPICE_READ_WHOLE(uint32_t)
COPPICE_READ_WHOLE(uint64_t)
#undef COPPICE_READ_WHOLE

// A prefix, as long as it is a plain number of its own; never by the locale.
bool parseDouble(StringView text, double& out, bool require_full_consumption) {
  const std::size_t end = text.find_first_not_of("0123456789+-.eEinfatyINFATY");
  const bool whole = end == StringView::npos;
  if (text.empty() || text.front() == '+' || (require_full_consumption && !whole)) return false;
  for (std::size_t size = std::min(end, text.size()); size > 0; --size) {
    if (coppice::ValueTraits<double>::Parse(text.substr(0, size), out)) {
      return size == text.size() || !require_full_consumption;
    }
  }
  return false;
}

template <>
double convertFromString<double>(StringView text) {
  double value = 0;
  if (!parseDouble(text, value, false)) {
    throw RuntimeError("Can't convert string [", text, "] to double");
  }
  return value;
}
template <>
float convertFromString<float>(StringView text) {
  return static_cast<float>(convertFromString<double>(text));
}
template <>
bool convertFromString<bool>(StringView text) {
  for (const StringView yes : {"1", "true", "True", "TRUE"}) {
    if (text == yes) return true;
  }
  for (const StringView no : {"0", "false", "False", "FALSE"}) {
    if (text == no) return false;
  }
  throw RuntimeError("Can't convert string [", text, "] to bool");
}
template <>
std::vector<int> convertFromString<std::vector<int>>(StringView text) {
  return internal::ReadList<int>(text);
}
template <>
std::vector<double> convertFromString<std::vector<double>>(StringView text) {
  return internal::ReadList<double>(text);
}
template <>
std::vector<bool> convertFromString<std::vector<bool>>(StringView text) {
  return internal::ReadList<bool>(text);
}
template <>
std::vector<std::string> convertFromString<std::vector<std::string>>(StringView text) {
  return internal::ReadList<std::string>(text);
}

// ---- Names of our enums.

namespace {

constexpr std::array<const char*, 5> kStatuses = {"IDLE", "RUNNING", "SUCCESS", "FAILURE",
                                                  "SKIPPED"};
constexpr std::array<const char*, 6> kNodeTypes = {"Undefined", "Action",    "Condition",
                                                   "Control",   "Decorator", "SubTree"};
constexpr std::array<const char*, 3> kDirections = {"Input", "Output", "InOut"};
constexpr std::array<const char*, 3> kLoudDirections = {"INPUT", "OUTPUT", "INOUT"};
constexpr std::array<const char*, 5> kColours = {"36", "33", "32", "31", "34"};

template <std::size_t count>
std::size_t Find(const std::array<const char*, count>& names, StringView name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

}  // namespace

template <>
NodeStatus convertFromString<NodeStatus>(StringView text) {
  const std::size_t number = Find(kStatuses, text);
  if (number == kStatuses.size()) throw RuntimeError("Cannot convert this to NodeStatus: ", text);
  return static_cast<NodeStatus>(number);
}
template <>
NodeType convertFromString<NodeType>(StringView text) {
  const std::size_t number = Find(kNodeTypes, text);
  return number == kNodeTypes.size() ? NodeType::UNDEFINED : static_cast<NodeType>(number);
}
template <>
PortDirection convertFromString<PortDirection>(StringView text) {
  const std::size_t number = std::min(Find(kDirections, text), Find(kLoudDirections, text));
  if (number == 3) throw RuntimeError("Cannot convert this to PortDirection: ", text);
  return static_cast<PortDirection>(number);
}

template <>
std::string toStr<bool>(const bool& value) {
  return value ? "true" : "false";
}
template <>
std::string toStr<std::string>(const std::string& value) {
  return value;
}
template <>
std::string toStr<NodeStatus>(const NodeStatus& status) {
  return kStatuses.at(static_cast<std::size_t>(status));
}
template <>
std::string toStr<NodeType>(const NodeType& type) {
  return kNodeTypes.at(static_cast<std::size_t>(type));
}
template <>
std::string toStr<PortDirection>(const PortDirection& direction) {
  return kDirections.at(static_cast<std::size_t>(direction));
}
std::string toStr(NodeStatus status, bool colored) {
  if (!colored) return toStr(status);
  return StrCat("\x1b[", kColours.at(static_cast<std::size_t>(status)), "m", toStr(status),
                "\x1b[0m");
}

std::ostream& operator<<(std::ostream& out, const NodeStatus& status) {
  return out << toStr(status);
}
std::ostream& operator<<(std::ostream& out, const NodeType& type) { return out << toStr(type); }
std::ostream& operator<<(std::ostream& out, const PortDirection& direction) {
  return out << toStr(direction);
}

// ---- Ports.

const std::string& TypeInfo::typeName() const {
  if (name_.empty()) name_ = type_ == typeid(AnyTypeAllowed) ? "AnyTypeAllowed" : demangle(type_);
  return name_;
}

Any TypeInfo::parseString(const std::string& text) const {
  if (!converter_) return {};
  try {
    return converter_(text);
  } catch (const std::exception&) {
    return {};
  }
}

char findForbiddenChar(StringView name) {
  for (const char c : name) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 32 || code == 127) return c;
    if (StringView(" <>&\"'/\\:*?|.").find(c) != StringView::npos) return c;
  }
  return '\0';
}

bool IsReservedAttribute(StringView name) {
  for (const char* reserved : {"name", "ID", "_autoremap", "_failureIf", "_successIf", "_skipIf",
                               "_while", "_onHalted", "_onFailure", "_onSuccess", "_post"}) {
    if (name == reserved) return true;
  }
  return false;
}

bool IsAllowedPortName(StringView name) {
  if (name.empty() || name.front() == '_' || IsReservedAttribute(name)) return false;
  const auto first = static_cast<unsigned char>(name.front());
  return (std::isalpha(first) || first >= 128) && findForbiddenChar(name) == '\0';
}

namespace internal {

void CheckPortName(StringView name) {
  if (IsAllowedPortName(name)) return;
  throw RuntimeError("\"", name,
                     "\" is no name for a port: a letter first, and not `name` or `ID`");
}

void CheckOutputDefault(StringView text) {
  if (text.size() >= 2 && text.front() == '{' && text.back() == '}') return;
  throw LogicError("the default of an output port is a key, as in \"{key}\", not \"", text, "\"");
}

}  // namespace internal
}  // namespace BT
