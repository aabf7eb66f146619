// Small helpers for tests of edits: parse, edit, and check what every edit must fulfil.
#ifndef COPPICE_TESTS_BT_CORE_MODEL_EDITED_H_
#define COPPICE_TESTS_BT_CORE_MODEL_EDITED_H_

#include <gtest/gtest.h>

#include <string>

#include "bt_core/model/document.h"

namespace coppice {

inline Document Parsed(const std::string& text) {
  Diagnostics diagnostics;
  auto document = Document::FromText(text, "t.xml", diagnostics);
  EXPECT_TRUE(document) << diagnostics.ToString() << text;
  return document ? *std::move(document) : Parsed("<unreadable/>");
}

/// The text after the edit, which is well-formed and can be undone.
inline std::string After(const Document& document, const Edit& edit) {
  std::string after = Apply(edit, document.text());
  Diagnostics diagnostics;
  EXPECT_TRUE(document.Edited(edit, diagnostics)) << diagnostics.ToString() << after;
  EXPECT_EQ(Apply(Inverse(edit, document.text()), after), document.text()) << "undo";
  return after;
}

/// The first element of that tag.
inline ElementIndex Find(const Document& document, std::string_view tag) {
  for (ElementIndex i{0}; i < document.elements().size(); ++i) {
    if (document.element(i).tag == tag) return i;
  }
  ADD_FAILURE() << "no <" << tag << ">";
  return kRootElement;
}

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_MODEL_EDITED_H_
