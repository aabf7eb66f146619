// A mapping of YAML from a text, for tests of what reads it.
#ifndef COPPICE_TESTS_ROBOT_APP_MONITORING_FIELDS_FIXTURE_H_
#define COPPICE_TESTS_ROBOT_APP_MONITORING_FIELDS_FIXTURE_H_

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "robot_app/common/yaml_fields.h"
#include "tests/robot_app/processes/temporary.h"

namespace coppice::robot::monitoring {

class FieldsTest : public testing::Test {
 protected:
  YamlFields Open(const std::string& text) {
    const std::string path = processes::Temporary("fields.yaml");
    std::ofstream(path) << text;
    return YamlFields::Load(path, diagnostics_);
  }
  std::string Errors() const { return diagnostics_.ToString(); }

  Diagnostics diagnostics_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_TESTS_ROBOT_APP_MONITORING_FIELDS_FIXTURE_H_
