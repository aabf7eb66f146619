// coppice-diff, which is `coppice diff`.
#include "editor/export/diff_verb.h"

int main(int argc, char** argv) {
  return coppice::FinishOutput(coppice::editor::RunDiff({argv + 1, argv + argc}));
}
