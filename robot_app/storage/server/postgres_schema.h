// What the store keeps in PostgreSQL: schema `coppice`, made by the first store that finds none.
// The views are for people and for Grafana: each has a column "time" and one "robot".
#ifndef COPPICE_ROBOT_APP_STORAGE_SERVER_POSTGRES_SCHEMA_H_
#define COPPICE_ROBOT_APP_STORAGE_SERVER_POSTGRES_SCHEMA_H_

namespace coppice::robot::storage {

// The key of a table in partitions contains what they are made by; a document that comes twice has
// the same time both times.
inline constexpr const char* kPostgresSchema = R"sql(
CREATE SCHEMA IF NOT EXISTS coppice;

CREATE TABLE coppice.types (
  name text NOT NULL,
  md5 text NOT NULL,
  definition text NOT NULL,
  PRIMARY KEY (name, md5));

CREATE TABLE coppice.messages (
  robot text NOT NULL,
  spool text NOT NULL,
  number bigint NOT NULL,
  time timestamptz NOT NULL,
  stamp bigint NOT NULL,
  topic text NOT NULL,
  type text NOT NULL,
  md5 text NOT NULL,
  document jsonb NOT NULL,
  PRIMARY KEY (robot, spool, number, time)) PARTITION BY RANGE (time);
CREATE INDEX ON coppice.messages (topic, time);
COMMENT ON COLUMN coppice.messages.time IS 'when it was heard';
COMMENT ON COLUMN coppice.messages.stamp IS 'ROS time then, in ns; simulated in a simulation';

CREATE TABLE coppice.losses (
  robot text NOT NULL,
  spool text NOT NULL,
  topic text NOT NULL,
  reason text NOT NULL,
  count bigint NOT NULL,
  first timestamptz NOT NULL,
  last timestamptz NOT NULL,
  PRIMARY KEY (robot, spool, topic, reason));

CREATE VIEW coppice.rates AS
  SELECT date_trunc('minute', time) AS time, robot, topic, count(*) / 60.0 AS per_second
  FROM coppice.messages GROUP BY 1, 2, 3;

CREATE VIEW coppice.battery AS
  SELECT time, robot,
         nullif(document->>'percentage', 'NaN')::float8 AS charge,
         nullif(document->>'voltage', 'NaN')::float8 AS voltage,
         nullif(document->>'current', 'NaN')::float8 AS current
  FROM coppice.messages WHERE type = 'sensor_msgs/BatteryState';

CREATE VIEW coppice.faults AS
  SELECT time, robot, entry->>'monitor' AS monitor, entry->>'subject' AS subject,
         (entry->>'level')::int AS level, entry->>'message' AS message
  FROM coppice.messages, jsonb_array_elements(document->'entries') AS entry
  WHERE type = 'coppice_msgs/Health' AND topic = '/monitoring' AND (entry->>'level')::int > 0;

CREATE VIEW coppice.recoveries AS
  SELECT time, robot, document->>'recovery' AS recovery, document->>'subject' AS subject,
         (ARRAY['begun', 'succeeded', 'failed', 'interrupted', 'refused', 'helped',
                'did not help'])[(document->>'phase')::int + 1] AS phase,
         (document->>'attempt')::int AS attempt, document->>'message' AS message
  FROM coppice.messages WHERE type = 'coppice_msgs/RecoveryEvent';

CREATE VIEW coppice.processes AS
  SELECT time, robot, process->>'name' AS process, (process->>'state')::int AS state,
         (process->>'restarts')::int AS restarts
  FROM coppice.messages, jsonb_array_elements(document->'processes') AS process
  WHERE type = 'coppice_msgs/ProcessStates';
)sql";

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_SERVER_POSTGRES_SCHEMA_H_
