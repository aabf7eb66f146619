#include "robot_app/common/places/topological_map.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "bt_core/base/advisor.h"
#include "robot_app/common/yaml_fields.h"

namespace coppice::robot {
namespace {

constexpr double kFarthest = 1e4;  // m
// A tree looks for ways within a tick, for which a few dozen are usual.
constexpr std::size_t kMostPlaces = 1000, kMostEdges = 4000;
constexpr EdgeKind kKinds[] = {EdgeKind::kDrive, EdgeKind::kDoor, EdgeKind::kDock,
                               EdgeKind::kUndock, EdgeKind::kElsewhere};

// Two letters: a language.
bool IsLanguage(const std::string& text) {
  return text.size() == 2 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

// "{en: [a, b], de: c}": one text or a list for each language.
std::vector<Wording> ReadWordings(YamlFields& fields, const std::string& key) {
  std::vector<Wording> wordings;
  for (const auto& [language, node] : fields.Pairs(key)) {
    if (!IsLanguage(language.text)) {
      fields.Error(language.where, "\"" + language.text + "\" is no language",
                   "two letters, such as en or de");
    }
    if (node.IsScalar()) {
      wordings.push_back({language.text, node.Scalar()});
      continue;
    }
    for (const LocatedText& text : fields.TextsOf(node)) {
      wordings.push_back({language.text, text.text});
    }
  }
  return wordings;
}

std::optional<Pose2D> ReadPose(YamlFields& fields) {
  const bool has_x = fields.Has("x"), has_y = fields.Has("y"), has_yaw = fields.Has("yaw");
  if (!has_x && !has_y && !has_yaw) return std::nullopt;
  if (!has_x || !has_y) {
    fields.Error(fields.where(), std::string("missing key \"") + (has_x ? "y" : "x") + "\"");
  }
  Pose2D pose;
  pose.x = fields.Number("x", 0, -kFarthest, kFarthest);
  pose.y = fields.Number("y", 0, -kFarthest, kFarthest);
  pose.yaw = NormalizeAngle(fields.Number("yaw", 0, -2 * M_PI, 2 * M_PI));
  return pose;
}

// Legs and files name places one behind the other.
bool IsName(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-' || c == '.';
  });
}

Place ReadPlace(YamlFields& fields) {
  Place place;
  const LocatedText name = fields.Text("name");
  place.name = name.text;
  if (!IsName(name.text)) {
    fields.Error(name.where, "\"" + name.text + "\" is no name of a place",
                 "letters, digits, \"_\", \"-\" and \".\"; what people say goes into called");
  }
  place.pose = ReadPose(fields);
  place.tolerance = fields.Number("tolerance", place.tolerance, 0.01, 100);
  for (const LocatedText& category : fields.Texts("categories")) {
    place.categories.push_back(category.text);
  }
  place.called = ReadWordings(fields, "called");
  for (const char* const category : {"patrol", "station"}) {
    if (!place.pose && place.Is(category)) {
      fields.Error(fields.where(),
                   std::string("a place of the category \"") + category + "\" needs x and y");
    }
  }
  fields.Finish();
  return place;
}

EdgeKind ReadKind(YamlFields& fields) {
  const std::string text =
      fields.Choice("by", "drive", {"drive", "door", "dock", "undock", "elsewhere"});
  return *std::find_if(std::begin(kKinds), std::end(kKinds),
                       [&](EdgeKind kind) { return text == ToString(kind); });
}

// What does not fit together in an edge whose ends are known.
void CheckEdge(YamlFields& fields, const std::vector<Place>& places, const Edge& edge, bool both) {
  const Place &from = places[static_cast<std::size_t>(edge.from)],
              &to = places[static_cast<std::size_t>(edge.to)];
  if (edge.kind == EdgeKind::kElsewhere) {
    if (edge.words.empty()) {
      fields.Error(fields.where(), "an edge by elsewhere needs words, which people are told");
    }
  } else if (!from.pose || !to.pose) {
    const Place& place = from.pose ? to : from;
    fields.Error(fields.where(), "\"" + place.name + "\" has no position, so nobody drives there",
                 "by: elsewhere");
  } else if (!edge.words.empty()) {
    fields.Error(fields.where(), "only an edge by elsewhere has words");
  }
  if (both && edge.kind != EdgeKind::kDrive && edge.kind != EdgeKind::kDoor) {
    fields.Error(fields.where(), "only an edge by drive or door goes both ways");
  }
}

}  // namespace

const char* ToString(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::kDrive:
      return "drive";
    case EdgeKind::kDoor:
      return "door";
    case EdgeKind::kDock:
      return "dock";
    case EdgeKind::kUndock:
      return "undock";
    case EdgeKind::kElsewhere:
      return "elsewhere";
  }
  return "";
}

std::string WordsIn(const std::vector<Wording>& words, const std::string& language) {
  for (const Wording& wording : words) {
    if (wording.language == language) return wording.text;
  }
  return words.empty() ? "" : words.front().text;
}

bool Place::Is(const std::string& category) const {
  return std::find(categories.begin(), categories.end(), category) != categories.end();
}

std::string Place::Spoken(const std::string& language) const {
  if (!called.empty()) return WordsIn(called, language);
  std::string text = name;
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::optional<TopologicalMap> TopologicalMap::Load(const std::string& path,
                                                   Diagnostics& diagnostics) {
  TopologicalMap map;
  YamlFields file = YamlFields::Load(path, diagnostics);
  map.site_ = file.Text("site", "").text;
  for (YamlFields& fields : file.Maps("places")) {
    if (map.places_.size() == kMostPlaces) {
      fields.Error(fields.where(), "more than " + std::to_string(kMostPlaces) + " places");
      break;
    }
    Place place = ReadPlace(fields);
    if (map.Find(place.name) >= 0) {
      fields.Error(fields.where(), "the name \"" + place.name + "\" is already taken");
    }
    map.places_.push_back(std::move(place));
  }
  if (map.places_.empty() && !diagnostics.has_errors()) {
    file.Error(file.where(), "there are no places");
  }
  Advisor advisor;
  const auto name_of = [](const Place& place) { return place.name; };
  for (YamlFields& fields : file.Maps("edges")) {
    if (map.edges_.size() >= kMostEdges) {
      fields.Error(fields.where(), "more than " + std::to_string(kMostEdges) + " edges");
      break;
    }
    Edge edge;
    for (auto [key, index] : {std::pair{"from", &edge.from}, {"to", &edge.to}}) {
      const LocatedText name = fields.Text(key);
      *index = map.Find(name.text);
      if (*index < 0 && !name.text.empty()) {
        fields.Error(name.where, "there is no place \"" + name.text + "\"",
                     advisor.Advise(name.text, map.places_, name_of));
      }
    }
    edge.kind = ReadKind(fields);
    edge.words = ReadWordings(fields, "words");
    const bool both = fields.Choice("both_ways", "false", {"true", "false"}) == "true";
    if (edge.from >= 0 && edge.to >= 0) CheckEdge(fields, map.places_, edge, both);
    fields.Finish();
    for (const Edge& way : {edge, Edge{edge.to, edge.from, edge.kind, {}}}) {
      if (map.FindEdge(way.from, way.to) >= 0) {
        fields.Error(fields.where(), "there is already an edge " + map.NameOf(way));
      }
      map.edges_.push_back(way);
      if (!both) break;
    }
  }
  file.Finish();
  if (diagnostics.has_errors()) return std::nullopt;
  return map;
}

std::vector<std::string> TopologicalMap::Names() const {
  std::vector<std::string> names;
  for (const Place& place : places_) names.push_back(place.name);
  return names;
}

int TopologicalMap::Find(const std::string& name) const {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

int TopologicalMap::FirstOf(const std::string& category) const {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i].Is(category)) return static_cast<int>(i);
  }
  return -1;
}

int TopologicalMap::FindEdge(int from, int to) const {
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (edges_[i].from == from && edges_[i].to == to) return static_cast<int>(i);
  }
  return -1;
}

std::string TopologicalMap::NameOf(const Edge& edge) const {
  const auto name = [&](int place) {
    return place < 0 ? std::string("?") : places_[static_cast<std::size_t>(place)].name;
  };
  return name(edge.from) + " -> " + name(edge.to);
}

int TopologicalMap::Nearest(const Pose2D& pose) const {
  int nearest = -1;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (!places_[i].pose) continue;
    if (nearest < 0 || Distance(*places_[i].pose, pose) <
                           Distance(*places_[static_cast<std::size_t>(nearest)].pose, pose)) {
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

int TopologicalMap::ChooseNext(std::mt19937& random, int last, const std::string& category) const {
  std::vector<int> choices;
  int others = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (!places_[i].pose || !places_[i].Is(category)) continue;
    choices.push_back(static_cast<int>(i));
    if (static_cast<int>(i) != last) ++others;
  }
  if (others > 0) choices.erase(std::remove(choices.begin(), choices.end(), last), choices.end());
  if (choices.empty()) return -1;
  // Not std::uniform_int_distribution: its sequence differs between standard libraries.
  return choices[random() % choices.size()];
}

}  // namespace coppice::robot
