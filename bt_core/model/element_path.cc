#include "bt_core/model/element_path.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

namespace coppice {
namespace {

struct Step {
  std::string_view name;
  int number = 1;
};

Step ParseStep(std::string_view text) {
  const std::size_t bracket = text.rfind('[');
  if (bracket == std::string_view::npos || text.back() != ']') return {text};
  int number = 0;
  const char* const end = text.data() + text.size() - 1;
  const auto [stop, error] = std::from_chars(text.data() + bracket + 1, end, number);
  if (error != std::errc() || stop != end) return {text};
  return {text.substr(0, bracket), number};
}

bool Fits(const Document& document, const Element& element, std::string_view name) {
  return document.AttributeValue(element, "name") == name ||
         document.AttributeValue(element, "ID") == name || element.tag == name;
}

ElementIndex FindChild(const Document& document, ElementIndex parent, Step step) {
  for (ElementIndex i = document.element(parent).first_child; i != kNoElement;
       i = document.element(i).next_sibling) {
    if (Fits(document, document.element(i), step.name) && --step.number == 0) return i;
  }
  return kNoElement;
}

std::vector<std::string> NamesOfChildren(const Document& document, ElementIndex parent) {
  std::vector<std::string> names;
  for (ElementIndex i = document.element(parent).first_child; i != kNoElement;
       i = document.element(i).next_sibling) {
    for (const char* attribute : {"name", "ID"}) {
      names.emplace_back(document.AttributeValue(document.element(i), attribute));
    }
    names.emplace_back(document.element(i).tag);
  }
  names.erase(std::remove(names.begin(), names.end(), ""), names.end());
  return names;
}

}  // namespace

ElementIndex FindByPath(const Document& document, std::string_view path, Diagnostics& diagnostics) {
  ElementIndex at{0};
  while (!path.empty()) {
    const std::size_t slash = std::min(path.find('/'), path.size());
    const std::string_view text = path.substr(0, slash);
    path.remove_prefix(std::min(slash + 1, path.size()));
    const ElementIndex child = FindChild(document, at, ParseStep(text));
    if (child == kNoElement) {
      diagnostics.Error(
          document.Location(document.element(at).offset),
          "no \"" + std::string(text) + "\" in <" + std::string(document.element(at).tag) + ">",
          DidYouMean(text, NamesOfChildren(document, at)));
      return kNoElement;
    }
    at = child;
  }
  return at;
}

}  // namespace coppice
