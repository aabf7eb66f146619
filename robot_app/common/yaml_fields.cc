#include "robot_app/common/yaml_fields.h"

#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "bt_core/base/read_file.h"

namespace coppice::robot {
namespace {

constexpr std::size_t kLongest = 1 << 20;     // bytes
constexpr std::size_t kMostValues = 1 << 17;  // as written; as a node each takes a kilobyte
constexpr std::size_t kMostNodes = 1 << 20;   // with aliases (*name) written out
constexpr int kDeepest = 1000;                // levels; yaml-cpp reads no more without aliases

std::string ToText(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

// Counts values without keeping them.
class ValueCounter : public YAML::EventHandler {
 public:
  struct TooMany {};

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override { Count(); }
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {
    Count();
  }
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    Count();
  }
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    Count();
  }
  void OnMapEnd() override {}

 private:
  void Count() {
    if (++values_ > kMostValues) throw TooMany();
  }
  std::size_t values_ = 0;
};

bool HasTooManyValues(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  ValueCounter counter;
  try {
    parser.HandleNextDocument(counter);
  } catch (const ValueCounter::TooMany&) {
    return true;
  }
  return false;
}

// False if a few aliases of aliases stand for more than anybody writes, or one for what it is in.
bool IsOfReasonableSize(const YAML::Node& node, std::size_t& nodes, int depth) {
  if (++nodes > kMostNodes || depth > kDeepest) return false;
  for (const auto& child : node) {
    const bool is_pair = node.IsMap();
    if (is_pair && !IsOfReasonableSize(child.first, nodes, depth + 1)) return false;
    if (!IsOfReasonableSize(is_pair ? child.second : child, nodes, depth + 1)) return false;
  }
  return true;
}

}  // namespace

YamlFields::YamlFields(std::string file, YAML::Node node, Diagnostics& diagnostics)
    : file_(std::move(file)), node_(std::move(node)), diagnostics_(&diagnostics) {
  if (!node_.IsDefined() || node_.IsNull()) {
    node_ = YAML::Node(YAML::NodeType::Map);
  } else if (!node_.IsMap()) {
    Error(Where(node_), "expected \"key: value\" pairs");
    node_ = YAML::Node(YAML::NodeType::Map);
  }
  std::set<std::string> keys;
  for (const auto& pair : node_) {
    const std::string key = pair.first.IsScalar() ? pair.first.Scalar() : "";
    if (!keys.insert(key).second) Error(Where(pair.first), "duplicate key \"" + key + "\"");
  }
}

std::optional<YAML::Node> LoadYaml(const std::string& path, Diagnostics& diagnostics) {
  const std::optional<std::string> text = ReadFile(path, diagnostics, kLongest);
  return text ? ParseYaml(*text, path, diagnostics) : std::nullopt;
}

std::optional<YAML::Node> ParseYaml(const std::string& text, const std::string& file,
                                    Diagnostics& diagnostics) {
  const auto fail = [&](const YAML::Mark& mark, const std::string& message) {
    diagnostics.Error({file, static_cast<std::uint32_t>(mark.line + 1),
                       static_cast<std::uint32_t>(mark.column + 1)},
                      message);
    return std::nullopt;
  };
  const YAML::Mark begin;
  try {
    if (HasTooManyValues(text)) {
      return fail(begin, "more than " + std::to_string(kMostValues) + " values");
    }
    YAML::Node root = YAML::Load(text);
    std::size_t nodes = 0;
    if (IsOfReasonableSize(root, nodes, 0)) return root;
    return fail(begin, "too large with its aliases (*name) written out");
  } catch (const YAML::ParserException& error) {
    return fail(error.mark, error.msg);
  }
}

YamlFields YamlFields::Load(const std::string& path, Diagnostics& diagnostics) {
  const std::optional<YAML::Node> root = LoadYaml(path, diagnostics);
  if (root && root->IsMap()) return {path, *root, diagnostics};
  if (root) diagnostics.Error({path, 1, 1}, "expected a mapping of keys to values");
  return {path, YAML::Node(YAML::NodeType::Map), diagnostics};
}

SourceLocation YamlFields::Where(const YAML::Node& node) const {
  const YAML::Mark mark = node.Mark();
  if (mark.is_null()) return {file_, 0, 0};
  return {file_, static_cast<std::uint32_t>(mark.line + 1),
          static_cast<std::uint32_t>(mark.column + 1)};
}

bool YamlFields::Has(const std::string& key) const {
  return std::any_of(node_.begin(), node_.end(),
                     [&key](const auto& pair) { return pair.first.Scalar() == key; });
}

std::vector<std::string> YamlFields::Keys() const {
  std::vector<std::string> keys;
  for (const auto& pair : node_) keys.push_back(pair.first.Scalar());
  return keys;
}

YAML::Node YamlFields::Find(const std::string& key) {
  asked_.push_back(key);
  for (const auto& pair : node_) {
    if (pair.first.Scalar() == key) return pair.second;
  }
  return YAML::Node(YAML::NodeType::Undefined);
}

LocatedText YamlFields::Text(const std::string& key) {
  if (!Has(key)) {
    asked_.push_back(key);
    Error(where(), "\"" + key + "\" is missing");
    return {"", where()};
  }
  const LocatedText text = Text(key, "");
  if (text.text.empty() && Find(key).IsScalar()) Error(text.where, "\"" + key + "\" is empty");
  return text;
}

LocatedText YamlFields::Text(const std::string& key, const std::string& otherwise) {
  const YAML::Node node = Find(key);
  if (!node.IsDefined()) return {otherwise, where()};
  if (!node.IsScalar()) {
    Error(Where(node), "\"" + key + "\": expected a text");
    return {otherwise, Where(node)};
  }
  return {node.Scalar(), Where(node)};
}

std::string YamlFields::Choice(const std::string& key, const std::string& otherwise,
                               const std::vector<std::string>& choices) {
  const LocatedText text = Text(key, otherwise);
  if (std::find(choices.begin(), choices.end(), text.text) != choices.end()) return text.text;
  std::string expected;
  for (const std::string& choice : choices) expected += (expected.empty() ? "" : ", ") + choice;
  Error(text.where, "\"" + key + "\": \"" + text.text + "\" is none of " + expected,
        DidYouMean(text.text, choices));
  return otherwise;
}

std::optional<double> YamlFields::OptionalNumber(const std::string& key, double low, double high) {
  const YAML::Node node = Find(key);
  if (!node.IsDefined()) return std::nullopt;
  double number = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, number) || !std::isfinite(number)) {
    Error(Where(node), "\"" + key + "\": expected a number");
    return std::nullopt;
  }
  if (number < low || number > high) {
    Error(Where(node), "\"" + key + "\": " + ToText(number) + " is not within " + ToText(low) +
                           " and " + ToText(high));
    return std::nullopt;
  }
  return number;
}

double YamlFields::Number(const std::string& key, double otherwise, double low, double high) {
  return OptionalNumber(key, low, high).value_or(otherwise);
}

Duration YamlFields::Seconds(const std::string& key, double otherwise, double low, double high) {
  return std::chrono::duration_cast<Duration>(
      std::chrono::duration<double>(Number(key, otherwise, low, high)));
}

int YamlFields::Integer(const std::string& key, int otherwise, int low, int high) {
  const double number = Number(key, otherwise, low, high);
  if (number == std::floor(number)) return static_cast<int>(number);
  Error(Where(Find(key)), "\"" + key + "\": expected a whole number");
  return otherwise;
}

std::vector<LocatedText> YamlFields::Texts(const std::string& key) { return TextsOf(Find(key)); }

std::vector<LocatedText> YamlFields::TextsOf(const YAML::Node& node) const {
  std::vector<LocatedText> texts;
  if (!node.IsDefined() || node.IsNull()) return texts;
  if (!node.IsSequence()) {
    Error(Where(node), "expected a list");
    return texts;
  }
  for (const YAML::Node& item : node) {
    if (item.IsScalar()) {
      texts.push_back({item.Scalar(), Where(item)});
    } else {
      Error(Where(item), "expected a text");
    }
  }
  return texts;
}

YamlFields YamlFields::Map(const std::string& key) { return MapOf(Find(key)); }

YamlFields YamlFields::MapOf(const YAML::Node& node) const {
  return YamlFields(file_, node, *diagnostics_);
}

std::vector<YamlFields> YamlFields::Maps(const std::string& key) {
  std::vector<YamlFields> maps;
  const YAML::Node node = Find(key);
  if (!node.IsDefined() || node.IsNull()) return maps;
  if (!node.IsSequence()) {
    Error(Where(node), "\"" + key + "\": expected a list");
    return maps;
  }
  for (const YAML::Node& item : node) maps.push_back(MapOf(item));
  return maps;
}

std::vector<std::pair<LocatedText, YAML::Node>> YamlFields::Pairs(const std::string& key) {
  std::vector<std::pair<LocatedText, YAML::Node>> pairs;
  const YAML::Node node = Find(key);
  for (const auto& pair : MapOf(node).node_) {
    pairs.emplace_back(LocatedText{pair.first.Scalar(), Where(pair.first)}, pair.second);
  }
  return pairs;
}

void YamlFields::Error(const SourceLocation& where, std::string message, std::string hint) const {
  diagnostics_->Error(where, std::move(message), std::move(hint));
}

void YamlFields::Finish() const {
  for (const auto& pair : node_) {
    const std::string key = pair.first.Scalar();
    if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    Error(Where(pair.first), "unknown key \"" + key + "\"", DidYouMean(key, asked_));
  }
}

}  // namespace coppice::robot
