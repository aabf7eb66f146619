#include "robot_app/knowledge/understanding/language_words.h"

#include "robot_app/common/yaml_fields.h"
#include "robot_app/knowledge/store/folded_text.h"

namespace coppice::robot::knowledge {
namespace {

std::set<std::string> ReadSet(YamlFields& file, const std::string& key) {
  std::set<std::string> words;
  for (const LocatedText& text : file.Texts(key)) {
    for (const std::string& word : Words(text.text)) words.insert(word);
  }
  return words;
}

}  // namespace

LanguageWords LoadLanguageWords(const std::string& folder, Language language,
                                Diagnostics& diagnostics) {
  YamlFields file = YamlFields::Load(folder + "/words." + Code(language) + ".yaml", diagnostics);
  LanguageWords words;
  words.fillers = ReadSet(file, "fillers");
  words.from = ReadSet(file, "from");
  words.of = ReadSet(file, "of");
  words.titles = ReadSet(file, "titles");
  for (const auto& [number, node] : file.Pairs("numbers")) {
    for (const LocatedText& word : file.TextsOf(node)) {
      words.numbers[Folded(word.text)] = number.text;
    }
  }
  for (const auto& [contraction, node] : file.Pairs("contractions")) {
    for (const LocatedText& text : file.TextsOf(node)) {
      words.contractions[Folded(contraction.text)] = Folded(text.text);
    }
  }
  for (const LocatedText& text : file.Texts("greetings")) words.greetings.push_back(text.text);
  for (const LocatedText& text : file.Texts("courtesies")) words.courtesies.push_back(text.text);
  for (const LocatedText& pattern : file.Texts("lines")) {
    if (pattern.text.find("{}") == std::string::npos) {
      file.Error(pattern.where, "expected {} where the name of the line stands");
    }
    words.line_patterns.push_back(pattern.text);
  }
  const std::vector<LocatedText> ordinals = file.Texts("ordinals");
  for (std::size_t i = 0; i < ordinals.size(); ++i) {
    for (const std::string& word : Words(ordinals[i].text)) words.ordinals[word] = i;
  }
  for (const auto& [day, node] : file.Pairs("days")) {
    for (const LocatedText& name : file.TextsOf(node)) {
      words.days.push_back({Kind::kDay, day.text, language, name.text, false});
    }
  }
  file.Finish();
  return words;
}

}  // namespace coppice::robot::knowledge
