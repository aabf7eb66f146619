// One element in one instance of its tree: what the parts of the compiler hand to each other.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILER_SITE_H_
#define COPPICE_BT_CORE_ENGINE_COMPILER_SITE_H_

#include <cstdint>

#include "bt_core/data/blackboard.h"
#include "bt_core/model/project.h"

namespace coppice {

struct Site {
  Site(const Project& project, std::uint32_t number, ElementIndex at, ScopeIndex in)
      : document(project.documents()[number]),
        element(document.element(at)),
        document_number(number),
        index(at),
        scope(in) {}

  const Document& document;
  const Element& element;
  std::uint32_t document_number;
  ElementIndex index;
  ScopeIndex scope;

  const Attribute* begin() const { return document.attributes_begin(element); }
  const Attribute* end() const { return document.attributes_end(element); }
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILER_SITE_H_
