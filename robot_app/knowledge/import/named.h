// What the readers of all files share: names in YAML, and that ids are given once.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_NAMED_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_NAMED_H_

#include <map>
#include <string>
#include <vector>

#include "bt_core/base/advisor.h"
#include "bt_core/base/diagnostic.h"
#include "robot_app/common/yaml_fields.h"
#include "robot_app/knowledge/store/records.h"

namespace coppice::robot::knowledge {

/// The ids of one kind of things, each with the place where it is given.
class Ids {
 public:
  explicit Ids(std::string what) : what_(std::move(what)) {}

  /// False, with an error, if it was given before.
  bool Add(const LocatedText& id, Diagnostics& diagnostics);
  /// An error, with the nearest one as a hint, if there is no such id.
  void Expect(const LocatedText& id, Diagnostics& diagnostics);
  bool Has(const std::string& id) const { return places_.count(id) > 0; }

 private:
  std::string what_;
  Advisor advisor_;
  std::map<std::string, SourceLocation> places_;
};

/// `key: {en: Library, de: Bibliothek}`, all languages needed.
ByLanguage<std::string> ReadTexts(YamlFields& fields, const std::string& key);
/// The same, where each may be missing.
ByLanguage<std::string> ReadOptionalTexts(YamlFields& fields, const std::string& key);

/// `name: {en: Library, de: Bibliothek}` and, if there are others, `also: {en: [books], de: []}`.
void ReadNames(YamlFields& fields, Kind kind, const std::string& subject, std::vector<Name>& names);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_NAMED_H_
