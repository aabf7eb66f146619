// coppice-knowledge: what the robot knows of its site, from the command line.
#include <SQLiteCpp/Exception.h>

#include <cstdio>
#include <iostream>
#include <map>
#include <new>
#include <string>
#include <vector>

#include "bt_core/base/verbs.h"
#include "robot_app/common/limits/largest_allocation.h"
#include "robot_app/common/shipped.h"
#include "robot_app/knowledge/answers/dialogue.h"
#include "robot_app/knowledge/import/gtfs_feed.h"
#include "robot_app/knowledge/import/read_campus.h"
#include "robot_app/knowledge/store/notes.h"
#include "robot_app/knowledge/store/queries.h"
#include "robot_app/knowledge/store/write_campus.h"

namespace coppice::robot::knowledge {
namespace {

const CommandOption kLanguageOption =
    CommandOption::OneOf("--language", {"en", "de"}, "of the text; else en");

const Command kImport{
    "coppice-knowledge import",
    "read what is known of the site",
    {"FOLDER DB", 2, 2},
    "Reads places.yaml, campus.yaml, staff.csv, small_talk.yaml, menus/ and transport/ of\n"
    "FOLDER and replaces what is in the database DB, which a robot may be reading. If anything\n"
    "is wrong in the files, all of it is said and nothing is replaced.",
    {CommandOption::Whole("--memory", "MIB", 16, 1 << 20, "that it may take; else 200")}};
const Command kShow{
    "coppice-knowledge show",
    "say what is in the database",
    {"DB [KIND]", 1, 2},
    "Says how much is known, or what all subjects of a KIND are called: person, place,\n"
    "category, line, stop, diet or topic.",
    {}};
const Command kAsk{
    "coppice-knowledge ask",
    "answer what a visitor asks",
    {"DB TEXT...", 2, kAnyNumber},
    "Answers each TEXT as the robot would, one after the other in one conversation.\n"
    "What cannot be answered is noted (`coppice-knowledge unknown DB`).",
    {kLanguageOption,
     CommandOption::Text("--at", "\"DAY HH:MM\"",
                         "of the site, such as \"2026-11-25 12:00\"; else now"),
     CommandOption::Flag("--meaning", "also says how the robot looks and what it shows")}};
const Command kUnknown{
    "coppice-knowledge unknown",
    "list what the robot could not answer",
    {"DB", 1, 1},
    "Lists what people asked without getting an answer, the most frequent first.",
    {CommandOption::Flag("--clear", "forgets them")}};
const Command kSynonym{
    "coppice-knowledge synonym",
    "give something one more name",
    {"DB [KIND SUBJECT NAME]", 1, 4},
    "From now on NAME means SUBJECT, also after the next import. Without these, lists the\n"
    "names that were added.",
    {kLanguageOption, CommandOption::Flag("--remove", "takes the name away again")}};

int Fail(const std::string& problem) {
  std::cerr << "coppice-knowledge: " << problem << "\n";
  return 1;
}

int Import(const Options& options) {
  LimitMemory(static_cast<std::size_t>(options.Whole("--memory", 200)) << 20);
  Diagnostics diagnostics;
  const Campus campus = ReadCampus(options.files[0], diagnostics);
  if (diagnostics.has_errors()) {
    std::cerr << diagnostics.ToString();
    return 1;
  }
  auto database = Database::OpenOrCreate(options.files[1]);
  if (!database) return Fail(database.problem());
  const Outcome written = WriteCampus(*database, campus);
  if (!written) return Fail(written.problem());
  for (const Name& stray : StraySynonyms(*database)) {
    diagnostics.Warning({options.files[1], 0, 0},
                        std::string("there is no ") + Word(stray.kind) + " \"" + stray.subject +
                            "\" any more, which was to be called \"" + stray.text + "\"");
  }
  std::cerr << diagnostics.ToString();
  std::cout << campus.places.size() << " places, " << campus.people.size() << " people, "
            << campus.menus.size() << " menus, " << campus.trips.size() << " trips, "
            << campus.names.size() << " names\n";
  return 0;
}

int ShowKind(const Database& database, Kind kind) {
  std::map<std::string, std::vector<std::string>> names;
  for (const Name& name : Names(database)) {
    if (name.kind != kind) continue;
    names[name.subject].push_back(std::string(Code(name.language)) + ":" + name.text);
  }
  for (const auto& [subject, texts] : names) {
    std::cout << subject;
    for (const std::string& text : texts) std::cout << "  " << text;
    std::cout << "\n";
  }
  return 0;
}

int ShowAll(const Database& database) {
  const std::optional<Site> site = FindSite(database);
  if (!site) return Fail("there is no knowledge yet: `coppice-knowledge import`");
  std::map<Kind, std::map<std::string, int>> subjects;
  for (const Name& name : Names(database)) ++subjects[name.kind][name.subject];
  std::cout << "time zone " << site->time_zone << "\n";
  for (const auto& [kind, names] : subjects) {
    std::cout << Word(kind) << " " << names.size() << "\n";
  }
  std::cout << "unknown " << UnknownRequests(database).size() << "\n"
            << "synonym " << Synonyms(database).size() << "\n";
  return 0;
}

int Show(const Options& options) {
  std::optional<Kind> kind;
  if (options.files.size() > 1) {
    kind = KindOf(options.files[1]);
    if (!kind) {
      return RefuseOptions(kShow, "unknown kind \"" + options.files[1] + "\"");
    }
  }
  const auto database = Database::Open(options.files[0]);
  if (!database) return Fail(database.problem());
  return kind ? ShowKind(*database, *kind) : ShowAll(*database);
}

// Nothing if the text is no day and time.
std::optional<WallTime> MomentOf(const std::string& text, const SiteTime& time) {
  const std::size_t space = text.find(' ');
  if (space == std::string::npos) return std::nullopt;
  const auto day = ParseDay(text.substr(0, space));
  const auto clock = ParseGtfsTime(text.substr(space + 1) + ":00");
  if (!day || !clock) return std::nullopt;
  return time.OfTimetable(*day, *clock);
}

int Ask(const Options& options) {
  Diagnostics diagnostics;
  const auto dialogue =
      Dialogue::Open(options.files[0], Shipped(COPPICE_LANGUAGE_FOLDER), diagnostics);
  std::cerr << diagnostics.ToString();
  if (!dialogue) return 1;
  WallTime now = std::chrono::system_clock::now();
  if (options.Has("--at")) {
    const auto time = TimeOf(*Database::Open(options.files[0]));
    if (!time) return Fail(time.problem());
    const auto moment = MomentOf(options.Get("--at"), *time);
    if (!moment) return RefuseOptions(kAsk, "--at: expected a time such as \"2026-11-25 12:00\"");
    now = *moment;
  }
  dialogue->set_language(*LanguageOf(options.Get("--language", "en")));
  for (std::size_t i = 1; i < options.files.size(); ++i) {
    const Answer answer = dialogue->Hear(options.files[i], now);
    std::cout << answer.text << "\n";
    if (options.Has("--meaning")) {
      std::cout << "  " << Word(answer.mood) << (answer.guides ? ", guides" : "")
                << (answer.place.empty() ? "" : ", place " + answer.place) << "\n";
    }
  }
  return 0;
}

int Unknown(const Options& options) {
  auto database = Database::Open(options.files[0]);
  if (!database) return Fail(database.problem());
  for (const UnknownRequest& request : UnknownRequests(*database)) {
    std::cout << request.count << "  " << request.last << "  " << Code(request.language) << "  "
              << request.text << "\n";
  }
  if (!options.Has("--clear")) return 0;
  const Outcome cleared = ClearUnknown(*database);
  return cleared ? 0 : Fail(cleared.problem());
}

int Synonym(const Options& options) {
  const auto& files = options.files;
  if (files.size() != 1 && files.size() != 4) {
    return RefuseOptions(kSynonym, "expected KIND, SUBJECT and NAME, or none of them");
  }
  const std::optional<Kind> kind = files.size() > 1 ? KindOf(files[1]) : Kind::kPlace;
  if (!kind) return RefuseOptions(kSynonym, "unknown kind \"" + files[1] + "\"");
  auto database = Database::Open(files[0]);
  if (!database) return Fail(database.problem());
  if (files.size() == 1) {
    for (const Name& name : Synonyms(*database)) {
      std::cout << Word(name.kind) << "  " << name.subject << "  " << Code(name.language) << "  "
                << name.text << "\n";
    }
    return 0;
  }
  const Name name{*kind, files[2], *LanguageOf(options.Get("--language", "en")), files[3], false};
  const Outcome outcome =
      options.Has("--remove") ? RemoveSynonym(*database, name) : AddSynonym(*database, name);
  return outcome ? 0 : Fail(outcome.problem());
}

const std::vector<Verb> kVerbs = {{"import", kImport, Import},
                                  {"ask", kAsk, Ask},
                                  {"show", kShow, Show},
                                  {"unknown", kUnknown, Unknown},
                                  {"synonym", kSynonym, Synonym}};

}  // namespace
}  // namespace coppice::robot::knowledge

int main(int argc, char** argv) {
  try {
    return coppice::RunVerb("coppice-knowledge", coppice::robot::knowledge::kVerbs,
                            {argv + 1, argv + argc});
  } catch (const SQLite::Exception& error) {
    std::cerr << "coppice-knowledge: " << error.what() << "\n";
    return 1;
  } catch (const std::bad_alloc&) {
    std::cerr << "coppice-knowledge: the files hold more than there is memory for "
                 "(`coppice-knowledge import --memory`)\n";
    return 1;
  }
}
