#include "robot_app/knowledge/import/named.h"

namespace coppice::robot::knowledge {

bool Ids::Add(const LocatedText& id, Diagnostics& diagnostics) {
  const auto [place, is_new] = places_.emplace(id.text, id.where);
  if (is_new) return true;
  diagnostics.Error(id.where, "a second " + what_ + " \"" + id.text + "\"; the first is in " +
                                  place->second.file + ":" + std::to_string(place->second.line));
  return false;
}

void Ids::Expect(const LocatedText& id, Diagnostics& diagnostics) {
  if (Has(id.text)) return;
  diagnostics.Error(
      id.where, "there is no " + what_ + " \"" + id.text + "\"",
      advisor_.Advise(id.text, places_, [](const auto& known) { return known.first; }));
}

ByLanguage<std::string> ReadTexts(YamlFields& fields, const std::string& key) {
  ByLanguage<std::string> texts;
  YamlFields map = fields.Map(key);
  if (!fields.Has(key)) {
    fields.Error(fields.where(), "\"" + key + "\" is missing");
    return texts;
  }
  for (const Language language : kLanguages) {
    In(language, texts) = map.Text(Code(language)).text;
  }
  map.Finish();
  return texts;
}

ByLanguage<std::string> ReadOptionalTexts(YamlFields& fields, const std::string& key) {
  ByLanguage<std::string> texts;
  YamlFields map = fields.Map(key);
  for (const Language language : kLanguages) {
    In(language, texts) = map.Text(Code(language), "").text;
  }
  map.Finish();
  return texts;
}

void ReadNames(YamlFields& fields, Kind kind, const std::string& subject,
               std::vector<Name>& names) {
  const ByLanguage<std::string> main = ReadTexts(fields, "name");
  YamlFields also = fields.Map("also");
  for (const Language language : kLanguages) {
    names.push_back({kind, subject, language, In(language, main), true});
    for (const LocatedText& other : also.Texts(Code(language))) {
      names.push_back({kind, subject, language, other.text, false});
    }
  }
  also.Finish();
}

}  // namespace coppice::robot::knowledge
