#include <iostream>
#include <optional>
#include <string>

#include "bt_core/base/command_line.h"
#include "bt_core/cli/verbs.h"
#include "bt_core/model/attribute_edits.h"
#include "bt_core/model/element_path.h"
#include "bt_core/model/xml_text.h"

namespace coppice {
namespace {

struct Assignment {
  std::string path;
  std::string attribute;
  std::string value;
};

std::optional<Assignment> ParseAssignment(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::size_t at = equals == std::string::npos ? equals : text.rfind('@', equals);
  if (at == std::string::npos) return std::nullopt;
  Assignment assignment{text.substr(0, at), text.substr(at + 1, equals - at - 1),
                        text.substr(equals + 1)};
  if (!IsXmlName(assignment.attribute)) return std::nullopt;
  return assignment;
}

// The document with the assignment done; nothing, with the reason printed, if that cannot be.
std::optional<Document> Assign(const Document& document, const std::string& text) {
  const std::optional<Assignment> assignment = ParseAssignment(text);
  if (!assignment) {
    RefuseOptions(CatCommand(), "expected PATH@ATTRIBUTE=VALUE, not \"" + text + "\"");
    return std::nullopt;
  }
  Diagnostics diagnostics;
  const ElementIndex element = FindByPath(document, assignment->path, diagnostics);
  std::optional<Document> edited;
  if (element != kNoElement) {
    edited = document.Edited(
        SetAttribute(document, element, assignment->attribute, assignment->value), diagnostics);
  }
  if (!edited) std::cerr << diagnostics.ToString();
  return edited;
}

}  // namespace

const Command& CatCommand() {
  static const Command command{
      "coppice cat",
      "print a file, with attributes set",
      {"FILE", 1, 1},
      R"(Prints the file, byte for byte, with attributes set; nothing else changes. PATH is
the ID of a tree and the steps below it: Main/Sequence/Timeout[2]@msec=500. A step is the
name, the ID or the tag of a node; [n] takes the n-th that fits.)",
      {CommandOption::Text("--set", "PATH@ATTRIBUTE=VALUE", "what to set; may be several").List()}};
  return command;
}

int RunCat(const Arguments& arguments) {
  const Options options = ParseOptions(CatCommand(), arguments);
  if (options.exit) return *options.exit;
  Diagnostics diagnostics;
  std::optional<Document> document = Document::FromFile(options.files[0], diagnostics);
  std::cerr << diagnostics.ToString();
  for (const std::string& assignment : options.GetAll("--set")) {
    if (document) document = Assign(*document, assignment);
  }
  if (!document) return 2;
  std::cout << document->text();
  return 0;
}

}  // namespace coppice
