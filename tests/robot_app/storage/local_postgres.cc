#include "tests/robot_app/storage/local_postgres.h"

#include <fcntl.h>
#include <pwd.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <pqxx/pqxx>
#include <stdexcept>

#include "robot_app/common/start_program.h"
#include "robot_app/processes/launch/ros_master.h"
#include "robot_app/storage/server/postgres_server.h"
#include "tests/robot_app/eventually.h"

namespace coppice::robot::storage {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPassword = "for the tests only";

int StartLogged(const std::vector<std::string>& command, const std::string& log) {
  const int output = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  const Expected<int> pid = StartProgram({command, {}, -1, output});
  close(output);
  if (!pid) throw std::runtime_error(pid.problem());
  return *pid;
}

void Run(const std::vector<std::string>& command, const std::string& log) {
  int status = 0;
  waitpid(StartLogged(command, log), &status, 0);
  if (status == 0) return;
  std::ifstream text(log);
  throw std::runtime_error(command[0] + " failed:\n" +
                           std::string(std::istreambuf_iterator<char>(text), {}));
}

// The folder of initdb and postgres, of the newest version.
std::string FindPrograms() {
  std::string found;
  std::error_code error;
  for (const fs::directory_entry& version : fs::directory_iterator("/usr/lib/postgresql", error)) {
    const std::string folder = version.path() / "bin";
    if (fs::exists(folder + "/initdb") && folder > found) found = folder;
  }
  if (found.empty()) throw std::runtime_error("no PostgreSQL here: install postgresql-15");
  return found;
}

}  // namespace

LocalPostgres::LocalPostgres() : programs_(FindPrograms()) {
  std::string name = "/tmp/coppice-pg-XXXXXX";  // short: it is part of the name of a socket
  if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
  folder_ = name;
  const passwd* user = getuid() == 0 ? getpwnam("postgres") : nullptr;
  if (user && chown(name.c_str(), user->pw_uid, user->pw_gid) != 0) {
    throw std::runtime_error("chown failed");
  }
  owner_.host = folder_;
  owner_.port = processes::FreePort();
  owner_.database = "postgres";
  owner_.user = "owner";
  owner_.is_encrypted = false;
  by_network_ = {ServerConfig::Kind::kPostgresql,
                 "localhost",
                 owner_.port,
                 "robots",
                 "store",
                 kPassword,
                 true,
                 File("authority.crt")};
  MakeCluster();
  MakeCertificates();
  Start();
  MakeRole();
}

LocalPostgres::~LocalPostgres() {
  if (pid_ != 0) Kill();
  std::error_code error;
  fs::remove_all(folder_, error);
}

// It ends when its starter does.
std::vector<std::string> LocalPostgres::AsItsUser(std::vector<std::string> command) const {
  if (getuid() != 0) return command;
  std::vector<std::string> whole{"setpriv",        "--reuid=postgres", "--regid=postgres",
                                 "--clear-groups", "--pdeathsig=QUIT", "--"};
  whole.insert(whole.end(), command.begin(), command.end());
  return whole;
}

void LocalPostgres::MakeCluster() {
  Run(AsItsUser({programs_ + "/initdb", "-D", File("data"), "-U", "owner", "--auth=trust",
                 "--no-sync", "--encoding=UTF8", "--locale=C"}),
      "/tmp/coppice-initdb-" + std::to_string(getpid()) + ".log");
  std::ofstream(File("data/pg_hba.conf")) << "local all owner trust\n"
                                             "hostssl all store 127.0.0.1/32 scram-sha-256\n"
                                             "hostssl all store ::1/128 scram-sha-256\n";
}

// An authority, what it has signed for the server, and an authority that has signed nothing.
void LocalPostgres::MakeCertificates() {
  const std::string log = "/tmp/coppice-initdb-" + std::to_string(getpid()) + ".log";
  const auto run = [&](const std::string& line) {
    Run(AsItsUser({"sh", "-c", "cd " + folder_ + " && " + line}), log);
  };
  for (const std::string name : {"authority", "stranger"}) {
    run("openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 -subj /CN=" +
        name + " -keyout " + name + ".key -out " + name + ".crt");
  }
  run("openssl req -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -subj /CN=localhost -keyout server.key -out server.csr");
  run("openssl x509 -req -in server.csr -CA authority.crt -CAkey authority.key -CAcreateserial "
      "-days 2 -out server.crt");
  fs::remove(log);
}

void LocalPostgres::MakeRole() {
  Ask(std::string("CREATE ROLE store LOGIN PASSWORD '") + kPassword + "'");
  Ask("CREATE DATABASE robots OWNER store");
}

bool LocalPostgres::TakesConnections() const {
  if (waitpid(pid_, nullptr, WNOHANG) != 0) return false;
  try {
    return Ask("SELECT 1").size() == 1;
  } catch (const std::exception&) {
    return false;
  }
}

// After a crash it refuses to start while a process of the old one is still ending.
void LocalPostgres::Start() {
  const std::vector<std::string> command = AsItsUser({programs_ + "/postgres",
                                                      "-D",
                                                      File("data"),
                                                      "-k",
                                                      folder_,
                                                      "-p",
                                                      std::to_string(owner_.port),
                                                      "-c",
                                                      "listen_addresses=localhost",
                                                      "-c",
                                                      "ssl=on",
                                                      "-c",
                                                      "ssl_cert_file=" + File("server.crt"),
                                                      "-c",
                                                      "ssl_key_file=" + File("server.key"),
                                                      "-c",
                                                      "shared_buffers=32MB",
                                                      "-c",
                                                      "recovery_init_sync_method=syncfs",
                                                      "-c",
                                                      "max_connections=20",
                                                      "-c",
                                                      "autovacuum=off"});
  const bool is_up = Eventually([&] {
    if (pid_ == 0 || waitpid(pid_, nullptr, WNOHANG) != 0) {
      pid_ = StartLogged(command, File("postgres.log"));
    }
    return TakesConnections();
  });
  if (!is_up) throw std::runtime_error("PostgreSQL does not start: see " + File("postgres.log"));
}

void LocalPostgres::End(int signal) {
  kill(pid_, signal);
  waitpid(pid_, nullptr, 0);
  pid_ = 0;
}

std::vector<std::string> LocalPostgres::Ask(const std::string& query,
                                            const std::string& database) const {
  ServerConfig config = owner_;
  config.database = database;
  pqxx::connection connection(ConnectionText(config));
  pqxx::nontransaction work(connection);
  std::vector<std::string> rows;
  for (const pqxx::row& row : work.exec(query)) {
    std::string text;
    for (const pqxx::field& field : row) {
      text += (text.empty() && field.num() == 0 ? "" : "|") + std::string(field.c_str());
    }
    rows.push_back(text);
  }
  return rows;
}

}  // namespace coppice::robot::storage
