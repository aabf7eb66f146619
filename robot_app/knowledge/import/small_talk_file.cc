#include "robot_app/knowledge/import/site_files.h"

namespace coppice::robot::knowledge {
namespace {

void ReadTopic(YamlFields& fields, Campus& campus, Ids& topics, Diagnostics& diagnostics) {
  const LocatedText id = fields.Text("id");
  topics.Add(id, diagnostics);
  YamlFields says = fields.Map("says");
  for (const Language language : kLanguages) {
    const auto phrases = says.Texts(Code(language));
    if (phrases.empty()) {
      fields.Error(fields.where(), std::string("expected what people say in ") + Code(language));
    }
    for (std::size_t i = 0; i < phrases.size(); ++i) {
      campus.names.push_back({Kind::kTopic, id.text, language, phrases[i].text, i == 0});
    }
  }
  says.Finish();
  const ByLanguage<std::string> reply = ReadTexts(fields, "reply");
  for (const Language language : kLanguages) {
    campus.replies.push_back({id.text, language, In(language, reply)});
  }
  fields.Finish();
}

}  // namespace

void ReadSmallTalk(const std::string& path, Campus& campus, Diagnostics& diagnostics) {
  YamlFields file = YamlFields::Load(path, diagnostics);
  Ids topics("topic");
  for (YamlFields& fields : file.Maps("topics")) ReadTopic(fields, campus, topics, diagnostics);
  file.Finish();
}

}  // namespace coppice::robot::knowledge
