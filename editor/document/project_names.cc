#include "editor/document/project_names.h"

#include <algorithm>
#include <set>
#include <utility>

#include "bt_core/model/attribute_edits.h"
#include "bt_core/model/keys.h"
#include "bt_core/model/manifest.h"
#include "bt_core/model/xml_text.h"
#include "editor/document/key_names.h"

namespace coppice::editor {
namespace {

bool IsSubTree(const Document& document, ElementIndex element) {
  const std::string_view tag = document.element(element).tag;
  return (tag == "SubTree" || tag == "SubTreePlus") && IsNode(document, element);
}

template <class Wanted>
std::vector<ElementIn> Where(const ProjectFiles& files, Wanted wanted) {
  std::vector<ElementIn> found;
  for (std::size_t f = 0; f < files.size(); ++f) {
    for (ElementIndex i{0}; i < files[f].elements().size(); ++i) {
      if (wanted(files[f], i)) found.push_back({f, i});
    }
  }
  return found;
}

// One key of some trees that share it.
class KeyRenaming {
 public:
  KeyRenaming(const ProjectFiles& files, const NodeModels& models, const std::string& key,
              const std::string& to)
      : files_(files), models_(models), key_(key), to_(to), edits_(files.size()) {}

  Expected<std::vector<Edit>> Run(ElementIn tree) {
    Reach(tree);
    while (!open_.empty()) {
      const ElementIn next = open_.back();
      open_.pop_back();
      RenameIn(next);
      RenamePorts(next);
    }
    if (!done_) return Problem{done_.problem()};
    return std::move(edits_);
  }

 private:
  void Reach(ElementIn tree) {
    if (reached_.insert({tree.file, tree.element}).second) open_.push_back(tree);
  }

  const Document& File(ElementIn place) const { return files_[place.file]; }

  void RenameIn(ElementIn tree) {
    for (const KeyName& name : KeyNamesIn(File(tree), models_, tree.element)) {
      if (name.key == to_ && !name.is_global) {
        done_ = Problem{"there is a key " + to_ + " already"};
      } else if (name.key == key_ && !name.is_global) {
        Change(tree.file, {WithKey(name, to_)});
      }
    }
    for (ElementIndex i = tree.element; i < EndOfBranch(File(tree), tree.element); ++i) {
      if (IsSubTree(File(tree), i) && SharesKey(File(tree), i)) {
        for (const ElementIn inner : TreesCalled(files_, TypeOf(File(tree), i))) Reach(inner);
      }
    }
  }

  bool SharesKey(const Document& document, ElementIndex subtree) const {
    return IsAutoremapped(document, document.element(subtree)) && !IsPrivateKey(key_) &&
           !document.FindAttribute(document.element(subtree), key_);
  }

  void RenamePorts(ElementIn tree) {
    const std::string_view id = File(tree).AttributeValue(File(tree).element(tree.element), "ID");
    for (const ElementIn use : SubTreesOf(files_, id)) {
      const Document& document = File(use);
      const Element& element = document.element(use.element);
      if (const Attribute* port = document.FindAttribute(element, key_)) {
        RenamePort(use, *port);
      } else if (SharesKey(document, use.element)) {
        Reach({use.file, TreeOf(document, use.element)});
      }
    }
  }

  void RenamePort(ElementIn use, const Attribute& port) {
    if (!IsXmlName(to_) || File(use).FindAttribute(File(use).element(use.element), to_)) {
      done_ = Problem{"a SubTree cannot have a port " + to_};
      return;
    }
    Change(use.file, RenameAttribute(File(use), use.element, port.name, to_));
    // goal="{=}" means the key of that name outside, which keeps its name.
    if (port.value == "=" || port.value == "{=}") {
      Change(use.file, {Replacement(port.value_offset, port.value_end, "{" + key_ + "}")});
    }
  }

  void Change(std::size_t file, const Edit& edit) {
    for (const Splice& splice : edit) {
      const bool known = std::any_of(edits_[file].begin(), edits_[file].end(),
                                     [&](const Splice& s) { return s.offset == splice.offset; });
      if (!known) edits_[file] = Merge(std::move(edits_[file]), {splice});
    }
  }

  const ProjectFiles& files_;
  const NodeModels& models_;
  const std::string& key_;
  const std::string& to_;
  std::vector<Edit> edits_;
  Outcome done_;
  std::set<std::pair<std::size_t, ElementIndex>> reached_;
  std::vector<ElementIn> open_;
};

}  // namespace

std::vector<ElementIn> TreesIn(const ProjectFiles& files) {
  return Where(files, [](const Document& document, ElementIndex i) {
    return document.element(i).tag == "BehaviorTree";
  });
}

std::vector<ElementIn> TreesCalled(const ProjectFiles& files, std::string_view id) {
  return Where(files, [id](const Document& document, ElementIndex i) {
    return document.element(i).tag == "BehaviorTree" &&
           document.AttributeValue(document.element(i), "ID") == id;
  });
}

std::vector<ElementIn> SubTreesOf(const ProjectFiles& files, std::string_view id) {
  return Where(files, [id](const Document& document, ElementIndex i) {
    return IsSubTree(document, i) && TypeOf(document, i) == id;
  });
}

CallersOfTree CallersOf(const ProjectFiles& files, std::string_view id) {
  CallersOfTree callers;
  for (const ElementIn use : SubTreesOf(files, id)) {
    callers.none = false;
    const Document& document = files[use.file];
    const Element& element = document.element(use.element);
    callers.autoremap = callers.autoremap || IsAutoremapped(document, element);
    for (const Attribute* a = document.attributes_begin(element);
         a != document.attributes_end(element); ++a) {
      if (!IsReservedAttribute(a->name)) callers.ports.emplace(a->name);
    }
  }
  return callers;
}

std::vector<Edit> RenameTree(const ProjectFiles& files, std::string_view id, std::string_view to) {
  std::vector<Edit> edits(files.size());
  for (std::size_t f = 0; f < files.size(); ++f) {
    const Document& document = files[f];
    for (ElementIndex i{0}; i < document.elements().size(); ++i) {
      const Element& element = document.element(i);
      const bool is_root = element.tag == "root";
      const bool has_id =
          element.tag == "BehaviorTree" || element.tag == "SubTree" || element.tag == "SubTreePlus";
      const char* name = is_root ? "main_tree_to_execute" : "ID";
      if (!(is_root || has_id) || document.AttributeValue(element, name) != id) continue;
      edits[f] = Merge(std::move(edits[f]), SetAttribute(document, i, name, to));
    }
  }
  return edits;
}

Expected<std::vector<Edit>> RenameKey(const ProjectFiles& files, const NodeModels& models,
                                      ElementIn in, const std::string& key, const std::string& to) {
  if (!IsKeyName(to) || to.front() == '@') {
    return Problem{"\"" + to + "\" cannot be the name of a key"};
  }
  return KeyRenaming(files, models, key, to).Run(in);
}

}  // namespace coppice::editor
