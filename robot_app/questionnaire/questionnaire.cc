#include "robot_app/questionnaire/questionnaire.h"

#include <nlohmann/json.hpp>

#include "bt_core/data/value.h"
#include "robot_app/common/yaml_fields.h"

namespace coppice::robot::questionnaire {
namespace {

ByLanguage ReadTexts(YamlFields fields) {
  ByLanguage texts;
  for (std::size_t i = 0; i < kLanguages.size(); ++i) texts[i] = fields.Text(kLanguages[i]).text;
  fields.Finish();
  return texts;
}

Item ReadItem(YamlFields& fields) {
  Item item;
  for (std::size_t i = 0; i < kLanguages.size(); ++i) {
    const std::vector<LocatedText> words = fields.Texts(kLanguages[i]);
    if (words.size() != 2) {
      fields.Error(fields.where(), std::string("expected two opposite words in ") + kLanguages[i]);
      continue;
    }
    item.low[i] = words[0].text;
    item.high[i] = words[1].text;
  }
  fields.Finish();
  return item;
}

void ReadPaper(YamlFields fields, Scale& scale) {
  scale.paper_alpha = fields.OptionalNumber("alpha", -100, 1);
  for (const LocatedText& text : fields.Texts("medians")) {
    double median = 0;
    if (!ValueTraits<double>::Parse(text.text, median))
      fields.Error(text.where, "expected a number");
    scale.paper_medians.push_back(median);
  }
  if (!scale.paper_medians.empty() && scale.paper_medians.size() != scale.items.size()) {
    fields.Error(fields.where(), "expected a median for each of the " +
                                     std::to_string(scale.items.size()) + " items");
  }
  fields.Finish();
}

Scale ReadScale(YamlFields& fields) {
  Scale scale;
  scale.id = fields.Text("id").text;
  scale.name = ReadTexts(fields.Map("name"));
  for (YamlFields& item : fields.Maps("items")) scale.items.push_back(ReadItem(item));
  if (scale.items.size() < 2) fields.Error(fields.where(), "a scale has at least two items");
  if (fields.Has("paper")) ReadPaper(fields.Map("paper"), scale);
  fields.Finish();
  return scale;
}

nlohmann::json ToJson(const ByLanguage& texts) {
  nlohmann::json json;
  for (std::size_t i = 0; i < kLanguages.size(); ++i) json[kLanguages[i]] = texts[i];
  return json;
}

}  // namespace

Questionnaire Questionnaire::Load(const std::string& path, Diagnostics& diagnostics) {
  YamlFields file = YamlFields::Load(path, diagnostics);
  Questionnaire questionnaire;
  questionnaire.title = ReadTexts(file.Map("title"));
  questionnaire.points = file.Integer("points", 5, 2, 11);
  for (YamlFields& scale : file.Maps("scales")) questionnaire.scales.push_back(ReadScale(scale));
  if (questionnaire.scales.empty()) file.Error(file.where(), "expected at least one scale");
  file.Finish();
  return questionnaire;
}

std::vector<std::string> Questionnaire::Columns() const {
  std::vector<std::string> columns;
  for (const Scale& scale : scales) {
    for (std::size_t i = 1; i <= scale.items.size(); ++i) {
      columns.push_back(scale.id + "_" + std::to_string(i));
    }
  }
  return columns;
}

std::string Questionnaire::ToJson() const {
  nlohmann::json items = nlohmann::json::array();
  for (const Scale& scale : scales) {
    for (const Item& item : scale.items) {
      items.push_back(
          {{"low", questionnaire::ToJson(item.low)}, {"high", questionnaire::ToJson(item.high)}});
    }
  }
  return nlohmann::json{
      {"title", questionnaire::ToJson(title)}, {"points", points}, {"items", items}}
      .dump();
}

}  // namespace coppice::robot::questionnaire
