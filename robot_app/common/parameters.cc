#include "robot_app/common/parameters.h"

#include <xmlrpcpp/XmlRpcValue.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "bt_core/base/diagnostic.h"

namespace coppice::robot {
namespace {

using XmlRpc::XmlRpcValue;

std::string ToText(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", number);
  return text;
}
std::string ToText(bool value) { return value ? "true" : "false"; }
std::string ToText(int number) { return std::to_string(number); }
std::string ToText(std::uint64_t number) { return std::to_string(number); }
std::string ToText(const std::string& text) { return text; }
std::string ToText(const Point2D& place) { return ToText(place.x) + " " + ToText(place.y); }
std::string ToText(const Pose2D& pose) {
  return ToText(pose.x) + " " + ToText(pose.y) + " " + ToText(pose.yaw);
}
template <typename Place>
std::string ToText(const std::optional<Place>& place) {
  return place ? ToText(*place) : "none";
}

std::string Quoted(const XmlRpcValue& given) {
  std::ostringstream text;
  text << given;
  return given.getType() == XmlRpcValue::TypeString ? '"' + text.str() + '"' : text.str();
}

std::string RangeOf(const Parameter& parameter) {
  return ToText(parameter.low) + ".." + ToText(parameter.high);
}

// What must be given for a value of this type.
std::string Wanted(bool /*value*/, const Parameter& /*parameter*/) { return "true or false"; }
std::string Wanted(double /*value*/, const Parameter& parameter) {
  return "a number, " + RangeOf(parameter);
}
std::string Wanted(std::uint64_t /*value*/, const Parameter& parameter) {
  return "a whole number, " + RangeOf(parameter);
}
std::string Wanted(int value, const Parameter& parameter) {
  return Wanted(static_cast<std::uint64_t>(value), parameter);
}
std::string Wanted(const std::string& /*value*/, const Parameter& /*parameter*/) {
  return "a text";
}
std::string Wanted(const std::optional<Point2D>& /*value*/, const Parameter& /*parameter*/) {
  return "\"X Y\" or none";
}
std::string Wanted(const std::optional<Pose2D>& /*value*/, const Parameter& /*parameter*/) {
  return "\"X Y YAW\" or none";
}

// Sets `value` to what is given; false if that is not what is wanted.
bool Take(const XmlRpcValue& given, const Parameter& /*parameter*/, bool& value) {
  const bool fits = given.getType() == XmlRpcValue::TypeBoolean;
  if (fits) value = static_cast<const bool&>(given);
  return fits;
}

bool Take(const XmlRpcValue& given, const Parameter& parameter, double& value) {
  double number = NAN;
  if (given.getType() == XmlRpcValue::TypeInt) number = static_cast<const int&>(given);
  if (given.getType() == XmlRpcValue::TypeDouble) number = static_cast<const double&>(given);
  const bool fits = number >= parameter.low && number <= parameter.high;
  if (fits) value = number;
  return fits;
}

template <typename Whole>
bool Take(const XmlRpcValue& given, const Parameter& parameter, Whole& value) {
  double number = 0;
  const bool fits = Take(given, parameter, number) && number == std::floor(number);
  if (fits) value = static_cast<Whole>(number);
  return fits;
}

bool Take(const XmlRpcValue& given, const Parameter& /*parameter*/, std::string& value) {
  if (given.getType() != XmlRpcValue::TypeString) return false;
  const std::string& text = given;
  if (!text.empty()) value = text;
  return !text.empty();
}

std::optional<Point2D> Parse(const std::string& text, const Point2D& /*kind*/) {
  return ParsePlace(text);
}
std::optional<Pose2D> Parse(const std::string& text, const Pose2D& /*kind*/) {
  return ParsePose(text);
}

template <typename Place>
bool Take(const XmlRpcValue& given, const Parameter& parameter, std::optional<Place>& value) {
  std::string text;
  if (!Take(given, parameter, text)) return false;
  const auto place = Parse(text, Place());
  if (place || text == "none") value = place;
  return place || text == "none";
}

// Its problem; empty if there is none.
std::string Read(const Parameter& parameter, const XmlRpcValue& given) {
  const auto read = [&](auto* value) {
    if (Take(given, parameter, *value)) return std::string();
    return "~" + parameter.name + " must be " + Wanted(*value, parameter) + ", not " +
           Quoted(given);
  };
  return std::visit(read, parameter.target);
}

}  // namespace

std::vector<std::string> ReadParameters(const Parameters& parameters, const XmlRpcValue& given) {
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters) names.push_back(parameter.name);
  std::vector<std::string> problems;
  if (given.getType() != XmlRpcValue::TypeStruct) return problems;
  for (const auto& [name, value] : given) {
    const auto known = std::find(names.begin(), names.end(), name);
    if (known == names.end()) {
      const std::string hint = DidYouMean(name, names);
      problems.push_back("unknown parameter ~" + name + (hint.empty() ? "" : " (" + hint + ")"));
    } else if (std::string problem = Read(parameters[known - names.begin()], value);
               !problem.empty()) {
      problems.push_back(std::move(problem));
    }
  }
  return problems;
}

std::string Explain(const Parameters& parameters) {
  std::string lines;
  for (const Parameter& parameter : parameters) {
    const std::string value =
        std::visit([](const auto* target) { return ToText(*target); }, parameter.target);
    const bool is_number = parameter.low < parameter.high;
    char line[256];
    std::snprintf(line, sizeof line, "    ~%-22s  %-9s  %-12s  %s\n", parameter.name.c_str(),
                  value.empty() ? "-" : value.c_str(), is_number ? RangeOf(parameter).c_str() : "-",
                  parameter.meaning.c_str());
    lines += line;
  }
  return lines;
}

}  // namespace coppice::robot
