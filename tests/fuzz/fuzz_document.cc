#include <cstdlib>
#include <memory>
#include <string>

#include "bt_core/engine/executor.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {
namespace {

class Anything : public SyncAction {
 public:
  Status Run() override { return Status::kSuccess; }
};

void Require(bool condition) {
  if (!condition) std::abort();
}

void CheckPositions(const Document& document) {
  for (const Element& element : document.elements()) {
    Require(document.text().at(element.offset) == '<');
    for (const Attribute* a = document.attributes_begin(element);
         a != document.attributes_end(element); ++a) {
      Require(document.text().compare(a->name_offset, a->name.size(), a->name) == 0);
      Require(a->value_offset < document.text().size());
    }
  }
}

void CheckSource(const Document& document) {
  const SourceText source(document);
  Require(source.text() == document.text());
  for (const Element& element : document.elements()) {
    const StartTag tag = source.StartTagAt(element.offset);
    Require(tag.name == element.tag && tag.attributes.size() == element.attribute_count);
    const Attribute* written = document.attributes_begin(element);
    for (const auto& [name, value] : tag.attributes) {
      Require(name == written->name && value == written->value);
      ++written;
    }
    const SourceLocation expected = document.Location(element.offset);
    const SourceLocation found = source.Location(element.offset);
    Require(found.line == expected.line && found.column == expected.column);
  }
}

void CheckDiagnostics(const Diagnostics& diagnostics, const std::string& text) {
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    Require(diagnostic.where.line >= 1 && diagnostic.where.column >= 1);
    Require(diagnostic.where.line <= text.size() + 1);
    Require(!diagnostic.message.empty());
  }
}

}  // namespace

int FuzzDocument(std::string_view bytes) {
  const std::string text(bytes);
  Diagnostics diagnostics;
  const std::optional<Document> document = Document::FromText(text, "", diagnostics);
  CheckDiagnostics(diagnostics, text);
  if (!document) {
    Require(diagnostics.has_errors());
    return 0;
  }
  CheckPositions(*document);
  CheckSource(*document);

  auto project = Project::FromText(text, "", diagnostics);
  CheckDiagnostics(diagnostics, text);
  Require(project.has_value());
  Require(project->has_errors() == diagnostics.has_errors());
  const bool whole = !project->has_errors();

  auto registry = std::make_shared<Registry>();
  registry->SetFallback([](const std::string&) { return std::make_unique<Anything>(); });
  const auto program =
      Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics);
  CheckDiagnostics(diagnostics, text);
  Require((program != nullptr) != diagnostics.has_errors());
  if (!whole) return 1;
  if (!program) return 2;

  SimulatedClock clock;
  Executor executor(program, clock);
  for (int i = 0; i < 3; ++i) {
    executor.Tick();
    clock.Advance(std::chrono::seconds(1));
  }
  executor.Halt();
  for (const Status status : executor.statuses()) Require(status == Status::kIdle);
  return 3;
}

}  // namespace coppice::fuzz
