// Reading configuration files strictly: every problem is reported with its place, all at once, and
// a key that nobody asked for is an error.
//
//   Diagnostics diagnostics;
//   YamlFields file = YamlFields::Load("robot.yaml", diagnostics);
//   YamlFields limits = file.Map("limits");
//   const double speed = limits.Number("speed", 0.5, 0.0, 2.0);
//   limits.Finish();
//   file.Finish();
//   if (diagnostics.has_errors()) std::cerr << diagnostics.ToString();
#ifndef COPPICE_ROBOT_APP_COMMON_YAML_FIELDS_H_
#define COPPICE_ROBOT_APP_COMMON_YAML_FIELDS_H_

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/diagnostic.h"

namespace coppice::robot {

/// A whole file as values, or an error at its line: at most 1 MiB and 131072 values, and no more
/// than eight times as many with aliases (*name) written out.
std::optional<YAML::Node> LoadYaml(const std::string& path, Diagnostics& diagnostics);
std::optional<YAML::Node> ParseYaml(const std::string& text, const std::string& file,
                                    Diagnostics& diagnostics);

/// A text of the file and where it stands.
struct LocatedText {
  std::string text;
  SourceLocation where;
};

/// The fields of one mapping. A missing mapping reads as an empty one. Getters never throw; after
/// an error they return their default. Not for several threads.
class YamlFields {
 public:
  /// Reads a whole file. A file that is missing or no YAML mapping is an error and reads as empty.
  static YamlFields Load(const std::string& path, Diagnostics& diagnostics);

  bool Has(const std::string& key) const;
  /// In the file's order.
  std::vector<std::string> Keys() const;
  SourceLocation where() const { return Where(node_); }

  /// A required text; an error if missing or empty.
  LocatedText Text(const std::string& key);
  LocatedText Text(const std::string& key, const std::string& otherwise);
  /// One of `choices`.
  std::string Choice(const std::string& key, const std::string& otherwise,
                     const std::vector<std::string>& choices);
  /// A number within [low, high].
  double Number(const std::string& key, double otherwise, double low, double high);
  /// Nothing if the key is missing.
  std::optional<double> OptionalNumber(const std::string& key, double low, double high);
  /// Seconds as a duration.
  Duration Seconds(const std::string& key, double otherwise, double low, double high);
  int Integer(const std::string& key, int otherwise, int low, int high);

  /// A list of texts; empty if the key is missing.
  std::vector<LocatedText> Texts(const std::string& key);
  YamlFields Map(const std::string& key);
  /// A list of mappings; empty if the key is missing.
  std::vector<YamlFields> Maps(const std::string& key);
  /// Every pair of a mapping with free keys. The values are to be read with TextsOf or MapOf.
  std::vector<std::pair<LocatedText, YAML::Node>> Pairs(const std::string& key);
  std::vector<LocatedText> TextsOf(const YAML::Node& node) const;
  YamlFields MapOf(const YAML::Node& node) const;

  void Error(const SourceLocation& where, std::string message, std::string hint = {}) const;

  /// Reports every key that was not asked for. Call it last.
  void Finish() const;

 private:
  YamlFields(std::string file, YAML::Node node, Diagnostics& diagnostics);

  SourceLocation Where(const YAML::Node& node) const;
  YAML::Node Find(const std::string& key);

  std::string file_;
  YAML::Node node_;
  Diagnostics* diagnostics_;
  std::vector<std::string> asked_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_YAML_FIELDS_H_
