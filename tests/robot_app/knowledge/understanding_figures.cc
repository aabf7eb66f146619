#include "tests/robot_app/knowledge/understanding_figures.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "bt_core/base/read_file.h"
#include "robot_app/knowledge/import/csv_table.h"
#include "tests/support/folders.h"

namespace coppice::robot::knowledge {
namespace {

std::vector<std::string> Split(const std::string& text, char by) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, by);) parts.push_back(part);
  return parts;
}

std::string TextOf(const Slot& slot) { return std::string(Word(slot.kind)) + "=" + slot.subject; }

std::vector<std::string> TextsOf(const std::vector<Slot>& slots) {
  std::vector<std::string> texts;
  for (const Slot& slot : slots) texts.push_back(TextOf(slot));
  std::sort(texts.begin(), texts.end());
  return texts;
}

bool Contains(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

}  // namespace

std::vector<SpokenExample> LoadExamples(const std::string& path) {
  Diagnostics diagnostics;
  std::vector<SpokenExample> examples;
  const auto text = coppice::ReadFile(path, diagnostics);
  if (text) {
    ReadCsv(path, BytesOf(*text),
            {{{"text", true}, {"intent", true}, {"slots", true}, {"held_out", true}}, false},
            diagnostics, [&examples](CsvRow& row) {
              auto& fields = row.fields;
              examples.push_back({fields[0], fields[1], fields[2], fields[3] == "yes"});
            });
  }
  if (diagnostics.has_errors()) throw std::runtime_error(diagnostics.ToString());
  return examples;
}

std::string UtterancesFile(Language language) {
  return SourceFolder() + "/tests/robot_app/knowledge/utterances." + Code(language) + ".csv";
}

Hearing HearingOf(const Understanding& heard, const SpokenExample& example) {
  if (example.intent == "none") {
    if (heard.verdict == Verdict::kUnknown) return Hearing::kRight;
    return heard.verdict == Verdict::kUnderstood ? Hearing::kWrongAction : Hearing::kWrongChoice;
  }
  if (heard.verdict == Verdict::kUnknown) return Hearing::kRefused;
  const bool is_intent = Word(heard.request.intent) == example.intent;
  const std::vector<std::string> choices = TextsOf(heard.choices);
  const std::size_t equals = example.slots.find('=');
  if (example.slots.find('|') != std::string::npos) {
    if (heard.verdict == Verdict::kUnderstood) return Hearing::kWrongAction;
    for (const std::string& subject : Split(example.slots.substr(equals + 1), '|')) {
      if (!Contains(choices, example.slots.substr(0, equals + 1) + subject)) {
        return Hearing::kWrongChoice;
      }
    }
    return is_intent ? Hearing::kRight : Hearing::kWrongChoice;
  }
  std::vector<std::string> wanted = Split(example.slots, ';');
  std::sort(wanted.begin(), wanted.end());
  if (heard.verdict == Verdict::kUnderstood) {
    return is_intent && TextsOf(heard.request.slots) == wanted ? Hearing::kRight
                                                               : Hearing::kWrongAction;
  }
  if (!is_intent) return Hearing::kWrongChoice;
  if (heard.verdict == Verdict::kMissing) return Hearing::kAsked;
  const bool is_there = std::any_of(wanted.begin(), wanted.end(), [&](const std::string& slot) {
    return Contains(choices, slot);
  });
  return is_there ? Hearing::kAsked : Hearing::kWrongChoice;
}

std::string TextOf(const Understanding& heard) {
  if (heard.verdict == Verdict::kUnknown) return "unknown [" + heard.unknown + "]";
  std::string text = Word(heard.request.intent);
  for (const Slot& slot : heard.request.slots) text += " " + TextOf(slot);
  if (heard.verdict == Verdict::kMissing) text += " which?";
  for (const Slot& choice : heard.choices) text += " " + TextOf(choice) + "?";
  return text;
}

void HearingCounts::Add(const SpokenExample& example, Hearing hearing) {
  const bool is_right = hearing == Hearing::kRight;
  if (example.intent == "none") {
    ++unanswerable;
    refused += is_right ? 1 : 0;
  } else {
    ++answerable;
    right += is_right ? 1 : 0;
  }
  asked += hearing == Hearing::kAsked ? 1 : 0;
  wrong_actions += hearing == Hearing::kWrongAction ? 1 : 0;
}

}  // namespace coppice::robot::knowledge
