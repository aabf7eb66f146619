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

constexpr char kUsage[] =
    "coppice cat FILE [--set PATH@ATTRIBUTE=VALUE ...]\n"
    "  Prints the file, byte for byte, with attributes set; nothing else changes. PATH is the ID "
    "of\n"
    "  a tree and the steps below it: Main/Sequence/Timeout[2]@msec=500. A step is the name, the\n"
    "  ID or the tag of a node; [n] takes the n-th that fits.";

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
    std::cerr << "expected PATH@ATTRIBUTE=VALUE, not \"" << text << "\"\nusage: " << kUsage << "\n";
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

int RunCat(const Arguments& arguments) {
  const std::optional<Options> options = ParseOptions(arguments, {}, {"--set"}, kUsage);
  if (!options) return 2;
  if (options->files.empty() || (options->files.size() > 1) != options->Has("--set")) {
    std::cerr << "expected one file and, behind --set, what to set\nusage: " << kUsage << "\n";
    return 2;
  }
  Diagnostics diagnostics;
  std::optional<Document> document = Document::FromFile(options->files[0], diagnostics);
  std::cerr << diagnostics.ToString();
  for (std::size_t i = 1; document && i < options->files.size(); ++i) {
    document = Assign(*document, options->files[i]);
  }
  if (!document) return 2;
  std::cout << document->text() << std::flush;
  return std::cout ? 0 : 2;
}

}  // namespace coppice
