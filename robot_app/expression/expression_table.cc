#include "robot_app/expression/expression_table.h"

#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include "robot_app/common/yaml_fields.h"

namespace coppice::robot::expression {
namespace {

constexpr double kShortest = 0.02, kLongest = 3600;  // s, of a step

struct ShapeForm {
  const char* name;
  ShapeKind kind;
  std::size_t numbers;
  const char* text;
};
constexpr ShapeForm kForms[] = {{"ring", ShapeKind::kRing, 5, "ring X Y RX RY WIDTH COLOUR"},
                                {"disc", ShapeKind::kDisc, 3, "disc X Y RADIUS COLOUR"},
                                {"arc", ShapeKind::kArc, 6, "arc X Y RADIUS WIDTH FROM TO COLOUR"},
                                {"line", ShapeKind::kLine, 5, "line X1 Y1 X2 Y2 WIDTH COLOUR"}};

std::optional<Colour> ColourOf(const std::string& text) {
  if (text.size() != 6 || text.find_first_not_of("0123456789abcdef") != std::string::npos) {
    return std::nullopt;
  }
  const unsigned long number = std::stoul(text, nullptr, 16);
  return Colour{static_cast<std::uint8_t>(number >> 16), static_cast<std::uint8_t>(number >> 8),
                static_cast<std::uint8_t>(number)};
}

bool ReadNumber(std::istringstream& words, double limit, double& number) {
  return words >> number && std::abs(number) <= limit;
}

bool ReadShape(std::istringstream& words, const ShapeForm& form, Shape& shape) {
  shape.kind = form.kind;
  for (std::size_t i = 0; i < form.numbers; ++i) {
    if (!ReadNumber(words, 1000, shape.numbers[i])) return false;
  }
  std::string colour;
  if (!(words >> colour) || !(words >> std::ws).eof()) return false;
  const std::optional<Colour> found = ColourOf(colour);
  if (found) shape.colour = *found;
  return found.has_value();
}

std::vector<Shape> ReadShapes(YamlFields& fields, const std::string& key) {
  std::vector<Shape> shapes;
  for (const LocatedText& text : fields.Texts(key)) {
    std::istringstream words(text.text);
    std::string name;
    words >> name;
    const ShapeForm* form = nullptr;
    for (const ShapeForm& candidate : kForms) {
      if (name == candidate.name) form = &candidate;
    }
    if (form == nullptr) {
      fields.Error(text.where, "\"" + name + "\" is no shape", "expected ring, disc, arc or line");
    } else if (!ReadShape(words, *form, shapes.emplace_back())) {
      fields.Error(text.where, "expected \"" + std::string(form->text) + "\"",
                   "a colour has six digits: 48c8ff");
    }
  }
  return shapes;
}

// One number for both sides, or those of the left and the right one.
std::array<double, 2> ReadPair(YamlFields& fields, const std::string& key, double limit) {
  const LocatedText text = fields.Text(key, "0");
  std::istringstream words(text.text);
  std::array<double, 2> pair{};
  const bool has_first = ReadNumber(words, limit, pair[0]);
  pair[1] = pair[0];
  const bool is_whole = (words >> std::ws).eof() || ReadNumber(words, limit, pair[1]);
  if (!has_first || !is_whole || !(words >> std::ws).eof()) {
    fields.Error(text.where, key + ": expected a number, or two", "");
  }
  return pair;
}

Colour ReadColour(YamlFields& fields, const std::string& key) {
  const LocatedText text = fields.Text(key, "000000");
  const std::optional<Colour> colour = ColourOf(text.text);
  if (!colour) fields.Error(text.where, key + ": expected a colour of six digits, such as 48c8ff");
  return colour.value_or(Colour{});
}

double ReadSeconds(YamlFields& fields) { return fields.Number("for", 1, kShortest, kLongest); }

FaceFrame ReadFrame(YamlFields& fields) {
  FaceFrame frame;
  frame.seconds = ReadSeconds(fields);
  frame.look = fields.Has("look") ? ReadPair(fields, "look", kFaceWidth) : frame.look;
  frame.eyes = ReadShapes(fields, "eyes");
  frame.also = ReadShapes(fields, "also");
  return frame;
}

LightStep ReadLights(YamlFields& fields) {
  return {ReadSeconds(fields), ReadColour(fields, "arms"), ReadColour(fields, "ears")};
}

LimbStep ReadLimbs(YamlFields& fields) {
  const double seconds = ReadSeconds(fields);
  const auto ears = ReadPair(fields, "ears", 3.2);
  const auto arms = ReadPair(fields, "arms", 3.2);
  return {seconds, {ears[0], ears[1], arms[0], arms[1]}};
}

template <typename Step>
std::vector<Step> ReadSteps(YamlFields& fields, const std::string& key,
                            Step (*read)(YamlFields& fields)) {
  std::vector<Step> steps;
  for (YamlFields& step : fields.Maps(key)) {
    steps.push_back(read(step));
    step.Finish();
  }
  if (steps.empty()) fields.Error(fields.where(), "expected at least one step of " + key);
  return steps;
}

Appearance ReadAppearance(YamlFields fields) {
  Appearance appearance;
  appearance.face = ReadSteps(fields, "face", ReadFrame);
  appearance.lights = ReadSteps(fields, "lights", ReadLights);
  appearance.limbs = ReadSteps(fields, "limbs", ReadLimbs);
  fields.Finish();
  return appearance;
}

// The step at a time, and how far it is over [0..1).
template <typename Step>
std::pair<std::size_t, double> StepAt(const std::vector<Step>& steps, double seconds) {
  double all = 0;
  for (const Step& step : steps) all += step.seconds;
  double rest = std::fmod(seconds, all);
  std::size_t i = 0;
  while (i + 1 < steps.size() && rest >= steps[i].seconds) rest -= steps[i++].seconds;
  return {i, rest / steps[i].seconds};
}

Colour Blend(const Colour& from, const Colour& to, double share) {
  Colour colour;
  for (std::size_t i = 0; i < colour.size(); ++i) {
    colour[i] = static_cast<std::uint8_t>(std::lround(from[i] + (to[i] - from[i]) * share));
  }
  return colour;
}

}  // namespace

ExpressionTable ReadExpressions(const std::string& path, Diagnostics& diagnostics) {
  YamlFields file = YamlFields::Load(path, diagnostics);
  ExpressionTable table;
  for (const Enumerator& one : ValueTraits<Expression>::kEnumerators) {
    const std::string name(one.name);
    if (!file.Has(name)) {
      file.Error(file.where(), "expected the expression " + name);
    } else {
      table[static_cast<Expression>(one.value)] = ReadAppearance(file.Map(name));
    }
  }
  file.Finish();
  return table;
}

const FaceFrame& FaceAt(const Appearance& appearance, double seconds) {
  return appearance.face[StepAt(appearance.face, seconds).first];
}

LightStep LightsAt(const Appearance& appearance, double seconds) {
  const auto [i, share] = StepAt(appearance.lights, seconds);
  const LightStep& from = appearance.lights[i];
  const LightStep& to = appearance.lights[(i + 1) % appearance.lights.size()];
  return {from.seconds, Blend(from.arms, to.arms, share), Blend(from.ears, to.ears, share)};
}

const LimbAngles& LimbsAt(const Appearance& appearance, double seconds) {
  return appearance.limbs[StepAt(appearance.limbs, seconds).first].angles;
}

}  // namespace coppice::robot::expression
