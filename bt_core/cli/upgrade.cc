#include "bt_core/model/upgrade.h"

#include <iostream>
#include <optional>
#include <string>

#include "bt_core/base/command_line.h"
#include "bt_core/cli/verbs.h"
#include "bt_core/model/project.h"
#include "bt_core/model/strictness.h"
#include "bt_core/model/write_file.h"

namespace coppice {
namespace {

// Of the file and all that it includes; what is wrong with those is no matter here.
TreeNames TreesUsedByName(const std::string& path) {
  Diagnostics of_others;
  const std::optional<Project> project = Project::FromFile(path, of_others);
  return project ? project->TreesUsedByName() : TreeNames();
}

// The whole new text, or nothing if the file cannot be read.
std::optional<std::string> Upgraded(const std::string& path) {
  Diagnostics reading;
  const std::optional<Document> document = Document::FromFile(path, reading);
  if (!document) {
    std::cerr << reading.ToString();
    return std::nullopt;
  }
  Diagnostics diagnostics;
  const auto strict = document->Rewritten(StrictXmlEdit(*document), diagnostics);
  diagnostics = Diagnostics();  // from here on about the format
  const Document& readable = strict ? *strict : *document;
  const TreeNames trees = IsFormat3(readable) ? TreesUsedByName(path) : TreeNames();
  std::string text = Apply(UpgradeToFormat4(readable, diagnostics, trees), readable.text());
  std::cerr << diagnostics.ToString();
  return text;
}

bool Put(const std::string& text, const std::string& path) {
  Diagnostics diagnostics;
  const bool written = WriteFile(path, text, diagnostics);
  std::cerr << diagnostics.ToString();
  return written;
}

}  // namespace

const Command& UpgradeCommand() {
  static const Command command{
      "coppice upgrade",
      "make trees of format 3 trees of format 4",
      {"FILE...", 1, kAnyNumber},
      R"(Makes trees of format 3 trees of format 4, and mends what only lax XML parsers
accept. Comments and layout stay. What it cannot upgrade is a warning. Prints the new file.)",
      {CommandOption::Flag("-i", "writes it in its place instead"),
       CommandOption::Text("-o", "OUTPUT", "writes it there instead; of one file")}};
  return command;
}

int RunUpgrade(const Arguments& arguments) {
  const Options options = ParseOptions(UpgradeCommand(), arguments);
  if (options.exit) return *options.exit;
  const bool in_place = options.Has("-i");
  if (options.Has("-o") && (in_place || options.files.size() > 1)) {
    return RefuseOptions(UpgradeCommand(), "expected either -i, or -o with one file");
  }
  bool good = true;
  for (const std::string& file : options.files) {
    const std::optional<std::string> text = Upgraded(file);
    if (!text) {
      good = false;
    } else if (in_place || options.Has("-o")) {
      good = Put(*text, in_place ? file : options.Get("-o")) && good;
    } else {
      std::cout << *text;
    }
  }
  return good ? 0 : 2;
}

}  // namespace coppice
