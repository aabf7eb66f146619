#include "editor/scene/problem_places.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace coppice::editor {
namespace {

bool IsAtOrBefore(const SourceLocation& a, const SourceLocation& b) {
  return std::tie(a.line, a.column) <= std::tie(b.line, b.column);
}

// kNoElement if the place is before the first element.
ElementIndex ElementAtPlace(const Document& document, const SourceLocation& where) {
  const std::vector<Element>& elements = document.elements();
  const auto after = std::partition_point(elements.begin(), elements.end(), [&](const Element& e) {
    return IsAtOrBefore(document.Location(e.offset), where);
  });
  if (after == elements.begin()) return kNoElement;
  return static_cast<ElementIndex>(after - elements.begin() - 1);
}

}  // namespace

std::vector<std::uint8_t> PlaceProblems(const Forest& forest, const Scene& scene,
                                        const std::vector<Diagnostic>& problems) {
  std::map<std::pair<std::uint32_t, ElementIndex>, std::uint8_t> worst;
  for (const Diagnostic& problem : problems) {
    if (problem.where.line == 0) continue;
    for (std::uint32_t d = 0; d < forest.documents().size(); ++d) {
      const Document& document = *forest.documents()[d];
      if (document.file() != problem.where.file) continue;
      std::uint8_t& known = worst[{d, ElementAtPlace(document, problem.where)}];
      known = std::max<std::uint8_t>(known, problem.severity == Severity::kError ? 2 : 1);
    }
  }
  std::vector<std::uint8_t> by_node;
  if (worst.empty()) return by_node;
  by_node.assign(scene.nodes.size(), 0);
  for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
    const auto found = worst.find({scene.nodes[i].document, scene.nodes[i].element});
    if (found != worst.end()) by_node[i] = found->second;
  }
  return by_node;
}

const Diagnostic* ProblemOfAttribute(const Document& document, const Attribute& attribute,
                                     const std::vector<Diagnostic>& problems) {
  const SourceLocation begin = document.Location(attribute.name_offset);
  const SourceLocation end = document.Location(attribute.value_end);
  for (const Diagnostic& problem : problems) {
    const bool inside = problem.where.file == document.file() && problem.where.line > 0 &&
                        IsAtOrBefore(begin, problem.where) && IsAtOrBefore(problem.where, end);
    if (inside) return &problem;
  }
  return nullptr;
}

}  // namespace coppice::editor
