// A forest of one text.
#ifndef COPPICE_TESTS_EDITOR_READ_FOREST_H_
#define COPPICE_TESTS_EDITOR_READ_FOREST_H_

#include <string>
#include <utility>
#include <vector>

#include "editor/scene/forest.h"

namespace coppice::editor {

inline Forest ReadForest(const std::string& xml, const std::string& file = "test") {
  Diagnostics diagnostics;
  std::optional<Document> document = Document::FromText(xml, file, diagnostics);
  std::vector<Document> documents;
  if (document) documents.push_back(*std::move(document));
  return Forest::FromDocuments(std::move(documents), {});
}

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_READ_FOREST_H_
