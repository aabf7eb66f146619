#include "robot_app/knowledge/store/notes.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include "bt_core/base/diagnostic.h"

namespace coppice::robot::knowledge {
namespace {

constexpr std::size_t kLongestNote = 200;  // bytes

// Not in the middle of a character of UTF-8.
std::string Shortened(std::string text) {
  if (text.size() <= kLongestNote) return text;
  std::size_t end = kLongestNote;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  text.resize(end);
  return text;
}

// One sentence with its values, as a transaction of its own; how many rows it changed.
template <class... Values>
Expected<int> Change(Database& database, const char* sql, const Values&... values) {
  try {
    SQLite::Statement statement(database.sqlite(), sql);
    int column = 0;
    (statement.bind(++column, values), ...);
    return statement.exec();
  } catch (const SQLite::Exception& error) {
    return Problem{error.what()};
  }
}

std::vector<Name> ReadSynonyms(const Database& database, const char* condition) {
  std::vector<Name> names;
  SQLite::Statement statement(
      database.sqlite(),
      std::string("SELECT kind, subject, language, text FROM synonym ") + condition);
  while (statement.executeStep()) {
    const auto kind = KindOf(statement.getColumn(0).getString());
    const auto language = LanguageOf(statement.getColumn(2).getString());
    if (!kind || !language) continue;
    names.push_back({*kind, statement.getColumn(1), *language, statement.getColumn(3), false});
  }
  return names;
}

std::vector<std::string> Subjects(const Database& database, Kind kind) {
  std::vector<std::string> subjects;
  SQLite::Statement statement(database.sqlite(),
                              "SELECT DISTINCT subject FROM name WHERE kind = ?");
  statement.bind(1, Word(kind));
  while (statement.executeStep()) subjects.push_back(statement.getColumn(0));
  return subjects;
}

bool Knows(const Database& database, const Name& name) {
  SQLite::Statement statement(database.sqlite(),
                              "SELECT 1 FROM name WHERE kind = ? AND subject = ?");
  statement.bind(1, Word(name.kind));
  statement.bind(2, name.subject);
  return statement.executeStep();
}

}  // namespace

void NoteUnknown(Database& database, const std::string& text, Language language, Day today) {
  const auto noted = Change(database,
                            "INSERT INTO unknown VALUES (?, ?, 1, ?) ON CONFLICT DO UPDATE "
                            "SET count = count + 1, last = excluded.last",
                            Shortened(text), Code(language), IsoText(today));
  if (!noted) return;
  (void)Change(database,
               "DELETE FROM unknown WHERE (text, language) IN (SELECT text, language FROM unknown "
               "ORDER BY last DESC, count DESC LIMIT -1 OFFSET ?)",
               kMostUnknown);
}

std::vector<UnknownRequest> UnknownRequests(const Database& database) {
  std::vector<UnknownRequest> requests;
  SQLite::Statement statement(database.sqlite(),
                              "SELECT text, language, count, last FROM unknown "
                              "ORDER BY count DESC, last DESC, text");
  while (statement.executeStep()) {
    const auto language = LanguageOf(statement.getColumn(1).getString());
    requests.push_back({statement.getColumn(0), language.value_or(Language::kEnglish),
                        statement.getColumn(2), statement.getColumn(3)});
  }
  return requests;
}

Outcome ClearUnknown(Database& database) {
  const auto cleared = Change(database, "DELETE FROM unknown");
  return cleared ? Outcome() : Problem{cleared.problem()};
}

Outcome AddSynonym(Database& database, const Name& name) {
  if (!Knows(database, name)) {
    const std::string hint = DidYouMean(name.subject, Subjects(database, name.kind));
    return Problem{std::string("there is no ") + Word(name.kind) + " \"" + name.subject + "\"" +
                   (hint.empty() ? "" : " (" + hint + ")")};
  }
  if (name.text.empty()) return Problem{"a name without a letter"};
  const auto added = Change(database, "INSERT OR IGNORE INTO synonym VALUES (?, ?, ?, ?)",
                            Word(name.kind), name.subject, Code(name.language), name.text);
  return added ? Outcome() : Problem{added.problem()};
}

Outcome RemoveSynonym(Database& database, const Name& name) {
  const auto removed = Change(
      database, "DELETE FROM synonym WHERE kind = ? AND subject = ? AND language = ? AND text = ?",
      Word(name.kind), name.subject, Code(name.language), name.text);
  if (!removed) return Problem{removed.problem()};
  if (*removed == 0) return Problem{"the operator has added no such name"};
  return {};
}

std::vector<Name> Synonyms(const Database& database) { return ReadSynonyms(database, ""); }

std::vector<Name> StraySynonyms(const Database& database) {
  return ReadSynonyms(database,
                      "WHERE NOT EXISTS (SELECT 1 FROM name WHERE name.kind = synonym.kind AND "
                      "name.subject = synonym.subject)");
}

}  // namespace coppice::robot::knowledge
