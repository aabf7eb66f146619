// coppice-export, which is `coppice export`.
#include "editor/export/export_verb.h"

int main(int argc, char** argv) {
  return coppice::FinishOutput(coppice::editor::RunExport({argv + 1, argv + argc}));
}
