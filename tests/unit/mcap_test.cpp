// MCAP files as tread writes them, taken apart byte by byte, and as others write them, put together here by the
// specification of the format.
#include <gtest/gtest.h>
#include <zstd.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <random>

#include "fuzz/import_entry.h"
#include "import/import.h"
#include "log/mcap_write.h"
#include "shared/import_problems.h"
#include "shared/scratch.h"

namespace tread::mcap_test {
namespace {

const std::string kSignature("\x89MCAP0\r\n", 8);

// ---- Writing files by hand ------------------------------------------------------------------------------------------

template <class T>
std::string number(T value, bool big_endian = false) {
    std::string bytes;
    for (std::size_t i = 0; i < sizeof(T); ++i)
        bytes += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * (big_endian ? sizeof(T) - 1 - i : i)));
    return bytes;
}
std::string u16(std::uint64_t value) {
    return number(static_cast<std::uint16_t>(value));
}
std::string u32(std::uint64_t value) {
    return number(static_cast<std::uint32_t>(value));
}
std::string u64(std::uint64_t value) {
    return number(value);
}
std::string text(const std::string& words) {
    return u32(words.size()) + words;
}
std::string record(int opcode, const std::string& content) {
    return std::string(1, static_cast<char>(opcode)) + u64(content.size()) + content;
}
std::string schema(int id, const std::string& name, const std::string& encoding, const std::string& words) {
    return record(3, u16(id) + text(name) + text(encoding) + text(words));
}
std::string channel(int id, int schema, const std::string& topic, const std::string& encoding) {
    return record(4, u16(id) + u16(schema) + text(topic) + text(encoding) + text(""));
}
std::string message(int id, std::uint64_t time, const std::string& bytes) {
    return record(5, u16(id) + u32(0) + u64(time) + u64(time) + bytes);
}
std::string chunk(const std::string& packing, const std::string& packed, std::uint64_t size, std::uint32_t sum = 0) {
    return record(6, u64(0) + u64(0) + u64(size) + u32(sum) + text(packing) + u64(packed.size()) + packed);
}
std::string zstd(const std::string& bytes) {
    std::string packed(ZSTD_compressBound(bytes.size()), '\0');
    packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1));
    return packed;
}
std::string mcapFile(const std::string& records) {
    return kSignature + record(1, text("") + text("by hand")) + records + record(15, u32(0)) +
           record(2, u64(0) + u64(0) + u32(0)) + kSignature;
}

// ---- Reading files by hand ------------------------------------------------------------------------------------------

std::uint64_t numberAt(const std::string& bytes, std::size_t at, std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = size; i > 0; --i) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i - 1));
    return value;
}

struct Record {
    int opcode;
    std::size_t begin, content, end;
};
std::vector<Record> recordsOf(const std::string& bytes, std::size_t begin, std::size_t end) {
    std::vector<Record> records;
    while (begin < end) {
        const std::size_t content = begin + 9, last = content + numberAt(bytes, begin + 1, 8);
        records.push_back({bytes.at(begin), begin, content, last});
        begin = last;
    }
    EXPECT_EQ(begin, end);
    return records;
}

// Bit by bit, as ISO 3309 defines it.
std::uint32_t sumOf(const std::string& bytes) {
    std::uint32_t rest = 0xFFFFFFFF;
    for (const char c : bytes) {
        rest ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ (rest & 1 ? 0xEDB88320 : 0);
    }
    return ~rest;
}

std::string written(const Log& log) {
    std::string bytes;
    writeMcap(log, "x.csv", "tread 0", [&](std::string_view piece) { bytes += piece; });
    return bytes;
}

Log driveOf(std::size_t rows) {
    Log log{{{"time", "s", {}},
             {"chassis.vx", "m/s", {}},
             {"wheel.front_left.spin", "rad/s", {}},
             {"chassis.yaw_rate@can", "rad/s", {}},
             {"chassis.ay", "m/s2", {}},
             {"note", "-", {}}}};
    for (std::size_t i = 0; i < rows; ++i) {
        const double t = static_cast<double>(i) / 1000;
        log.channels[0].values.push_back(t);
        for (std::size_t c = 1; c < log.channels.size(); ++c)
            log.channels[c].values.push_back(std::sin(t * static_cast<double>(c)) / 3);
    }
    return log;
}

TEST(Mcap, RecordsIndexesAndSumsAreThoseOfTheFormat) {
    const std::size_t rows = 6000, topics = 4;
    const std::string file = written(driveOf(rows));
    ASSERT_EQ(file.substr(0, 8), kSignature);
    ASSERT_EQ(file.substr(file.size() - 8), kSignature);
    const std::vector<Record> records = recordsOf(file, 8, file.size() - 8);
    std::string order;
    for (const Record& one : records) order += "?HFSCMKIX??T??OD"[one.opcode];
    const std::size_t chunks = static_cast<std::size_t>(std::count(order.begin(), order.end(), 'K'));
    ASSERT_GE(chunks, 2u);
    std::string expected = "HSSSSCCCC";
    for (std::size_t i = 0; i < chunks; ++i) expected += "KIIII";
    expected += "DSSSSCCCCT" + std::string(chunks, 'X') + "OOOOF";
    ASSERT_EQ(order, expected);

    // Sums: of all before the end of the data; of the summary up to the sum itself.
    const Record& data_end = records[order.find('D')];
    const Record& footer = records.back();
    EXPECT_EQ(numberAt(file, data_end.content, 4), sumOf(file.substr(0, data_end.begin)));
    const std::uint64_t summary = numberAt(file, footer.content, 8);
    EXPECT_EQ(summary, data_end.end);
    EXPECT_EQ(numberAt(file, footer.content + 16, 4), sumOf(file.substr(summary, footer.content + 16 - summary)));
    EXPECT_EQ(numberAt(file, footer.content + 8, 8), records[order.find('O')].begin);

    // Each group of the summary lies where its record says.
    for (std::size_t i = order.find('O'); order[i] == 'O'; ++i) {
        const std::size_t begin = numberAt(file, records[i].content + 1, 8);
        EXPECT_EQ(file.at(begin), file.at(records[i].content));
        for (const Record& one : recordsOf(file, begin, begin + numberAt(file, records[i].content + 9, 8)))
            EXPECT_EQ(one.opcode, file.at(records[i].content));
    }

    // Each index leads to a message of its channel and time; each chunk index to its chunk and its message indexes.
    std::size_t messages = 0, index_record = order.find('X');
    for (std::size_t k = order.find('K'); k < order.find('D'); k += 1 + topics, ++index_record) {
        const Record& one = records[k];
        const std::size_t size = numberAt(file, one.content + 16, 8), packed_at = one.content + 28 + 4 + 4 + 8;
        ASSERT_EQ(file.substr(one.content + 32, 4), "zstd");
        std::string inside(size, '\0');
        ASSERT_EQ(ZSTD_decompress(inside.data(), size, file.data() + packed_at, one.end - packed_at), size);
        EXPECT_EQ(numberAt(file, one.content + 24, 4), sumOf(inside));

        const Record& chunk_index = records[index_record];
        EXPECT_EQ(file.substr(chunk_index.content, 16), file.substr(one.content, 16)) << "first and last time";
        EXPECT_EQ(numberAt(file, chunk_index.content + 16, 8), one.begin);
        EXPECT_EQ(numberAt(file, chunk_index.content + 24, 8), one.end - one.begin);
        ASSERT_EQ(numberAt(file, chunk_index.content + 32, 4), topics * 10);
        std::size_t length = 0;
        for (std::size_t i = 0; i < topics; ++i) {
            const Record& index = records[k + 1 + i];
            length += index.end - index.begin;
            EXPECT_EQ(numberAt(file, chunk_index.content + 36 + 10 * i + 2, 8), index.begin);
            const std::string id = file.substr(index.content, 2);
            EXPECT_EQ(file.substr(chunk_index.content + 36 + 10 * i, 2), id);
            for (std::size_t at = index.content + 6; at < index.end; at += 16, ++messages) {
                const std::size_t place = numberAt(file, at + 8, 8);
                ASSERT_EQ(inside.at(place), 5);
                ASSERT_EQ(inside.substr(place + 9, 2), id);
                ASSERT_EQ(inside.substr(place + 15, 8), file.substr(at, 8));
            }
        }
        EXPECT_EQ(numberAt(file, chunk_index.content + 76, 8), length);
        EXPECT_EQ(numberAt(file, chunk_index.content + 92, 8), one.end - packed_at);
        EXPECT_EQ(numberAt(file, chunk_index.content + 100, 8), size);
    }
    EXPECT_EQ(messages, rows * topics);
    EXPECT_EQ(numberAt(file, records[order.find('T')].content, 8), messages);
    EXPECT_EQ(file, written(driveOf(rows))) << "the same log gives the same bytes";
}

TEST(Mcap, TopicsAreTheGroupsOfChannelsWithTheirUnits) {
    Log log = driveOf(1);
    log.channels[4].values[0] = std::numeric_limits<double>::quiet_NaN();
    const std::string file = written(log);
    const std::vector<Record> records = recordsOf(file, 8, file.size() - 8);
    EXPECT_EQ(
        file.substr(records[1].begin, records[1].end - records[1].begin),
        schema(1, "chassis", "jsonschema",
               R"({"type":"object","properties":{"vx":{"type":"number","title":"chassis.vx","description":"m/s"},)"
               R"("ay":{"type":"number","title":"chassis.ay","description":"m/s2"}}})"));
    const char* const topics[] = {"/chassis", "/wheel/front_left", "/can/chassis", "/log"};
    std::string expected, messages;
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(file.substr(records[5 + i].begin, records[5 + i].end - records[5 + i].begin),
                  channel(i + 1, i + 1, topics[i], "json"));
        expected += message(i + 1, 0,
                            i == 0   ? R"({"vx":0})"  // the other is not finite
                            : i == 1 ? R"({"spin":0})"
                            : i == 2 ? R"({"yaw_rate":0})"
                                     : R"({"note":0})");
    }
    const std::size_t packed = records[9].content + 44;
    messages.resize(expected.size());
    ASSERT_EQ(ZSTD_decompress(messages.data(), messages.size(), file.data() + packed, records[9].end - packed),
              expected.size());
    EXPECT_EQ(messages, expected);
}

TEST(Mcap, RefusesTimesBeyondSixtyFourBits) {
    Log log = driveOf(2);
    log.channels[0].values[1] = 1e10;
    EXPECT_EQ(faultsOf([&] { written(log); }),
              "x.csv: time: found 10000000000 s, expected at most 9200000000 s: MCAP counts nanoseconds in 64 bits");
}

// ---- Import ---------------------------------------------------------------------------------------------------------

ForeignTable tableOf(const std::string& bytes) {
    return parseMcap(bytes, "x.mcap");
}

Log imported(const std::string& bytes) {
    const ForeignTable table = tableOf(bytes);
    return importLog(table, guessMap(table).map).logs.at(0);
}

const ForeignColumn& columnOf(const ForeignTable& table, const std::string& name) {
    static const ForeignColumn none;
    const ForeignColumn* const column = table.find(name);
    EXPECT_NE(column, nullptr) << name;
    return column ? *column : none;
}

bool says(const ForeignTable& table, const std::string& words) {
    return std::any_of(table.notes.begin(), table.notes.end(),
                       [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

TEST(Mcap, LogOfTreadComesBackAsItWas) {
    Log log = driveOf(3000);
    log.channels[1].values[7] = std::numeric_limits<double>::quiet_NaN();
    log.channels[2].values.assign(3000, std::numeric_limits<double>::quiet_NaN());
    log.channels[4].values[3] = 1e-300;
    const Log back = imported(written(log));
    ASSERT_EQ(back.channels.size(), log.channels.size());
    for (const Channel& channel : log.channels) {
        const Channel* const same = back.find(channel.name);
        ASSERT_NE(same, nullptr) << channel.name;
        EXPECT_EQ(same->unit, channel.unit);
        for (std::size_t i = 0; i < channel.values.size(); ++i) {
            const double value = channel.values[i], got = same->values[i];
            ASSERT_TRUE(got == value || (std::isnan(got) && std::isnan(value))) << channel.name << " " << i;
        }
    }
}

const char* const kProbe =
    "# what a probe says\n"
    "std_msgs/Header header\n"
    "bool on  # or off\n"
    "float64 x\n"
    "int16[3] small\n"
    "uint8 FLAG=3\n"
    "uint8 flag 7\n"
    "geometry_msgs/Vector3[<=5] points\n"
    "string<=8 name\n"
    "Empty nothing\n"
    "float32 last\n"
    "================================================================================\n"
    "MSG: std_msgs/Header\n"
    "builtin_interfaces/Time stamp\n"
    "string frame_id\n"
    "================================================================================\n"
    "MSG: geometry_msgs/Vector3\n"
    "float64 x\nfloat64 y\nfloat64 z\n"
    "================================================================================\n"
    "MSG: probes/Empty\n";

std::string doubleBytes(double value, bool big) {
    return number(std::bit_cast<std::uint64_t>(value), big);
}

// Each number at a multiple of its size behind the four bytes of the encapsulation.
std::string probe(bool big, std::uint32_t sec, std::uint32_t nanosec, double x) {
    const auto pad = [](std::size_t bytes) { return std::string(bytes, '\xEE'); };
    std::string cdr(big ? "\0\0\0\0" : "\0\1\0\0", 4);
    cdr += number(sec, big) + number(nanosec, big);                                                        // 0
    cdr += number(std::uint32_t{4}, big) + std::string("imu\0", 4);                                        // 8
    cdr += std::string("\1", 1) + pad(7);                                                                  // 16
    cdr += doubleBytes(x, big);                                                                            // 24
    cdr += number(std::int16_t{-1}, big) + number(std::int16_t{2}, big) + number(std::int16_t{300}, big);  // 32
    cdr += std::string("\x07", 1) + pad(1);                                                                // 38
    cdr += number(std::uint32_t{1}, big) + pad(4);                                                         // 40
    cdr += doubleBytes(1.5, big) + doubleBytes(-2.5, big) + doubleBytes(3.5, big);                         // 48
    cdr += number(std::uint32_t{1}, big) + std::string("\0", 1);                                           // 72
    cdr += std::string("\0", 1) + pad(2);                     // 77: a type without fields
    cdr += number(std::bit_cast<std::uint32_t>(0.25f), big);  // 80
    return cdr;
}

TEST(Mcap, MessagesOfRos2AreReadInBothByteOrders) {
    for (const bool big : {false, true}) {
        std::string records = schema(7, "probes/msg/Probe", "ros2msg", kProbe) + channel(3, 7, "/probe", "cdr");
        for (std::uint32_t i = 0; i < 5; ++i)
            records += message(3, 1'000'000'000'000 + i, probe(big, 1000 + i, 500'000'000, 10.5 + i));
        const ForeignTable table = tableOf(mcapFile(chunk("", records, records.size(), sumOf(records))));
        EXPECT_EQ(columnOf(table, "/probe.time").values, std::vector<double>({0, 1, 2, 3, 4})) << "header.stamp";
        EXPECT_TRUE(says(table, "time counts from 1000.500000000 s"));
        EXPECT_EQ(columnOf(table, "/probe.x").values, std::vector<double>({10.5, 11.5, 12.5, 13.5, 14.5}));
        const std::map<std::string, double> expected = {
            {"on", 1},     {"small[0]", -1},     {"small[1]", 2},       {"small[2]", 300},
            {"flag", 7},   {"points[0].x", 1.5}, {"points[0].y", -2.5}, {"points[0].z", 3.5},
            {"last", 0.25}};
        for (const auto& [name, value] : expected)
            EXPECT_EQ(columnOf(table, "/probe." + name).values, std::vector<double>(5, value)) << name;
        EXPECT_EQ(table.columns.size(), 2 + expected.size());
    }
}

TEST(Mcap, MessagesOfRos1AreReadWithoutPadding) {
    const std::string definition =
        "Header header\nuint8 a\nfloat64 b\n====\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n";
    std::string records = schema(1, "old/Old", "ros1msg", definition) + channel(1, 1, "old", "ros1");
    for (std::uint32_t i = 1; i < 4; ++i)
        records += message(1, i,
                           number(i) + number(i) + number(i * 1000) + number(std::uint32_t{1}) + "f" + "\x05" +
                               doubleBytes(0.5 * i, false));
    const ForeignTable table = tableOf(mcapFile(chunk("zstd", zstd(records), records.size())));
    EXPECT_EQ(columnOf(table, "old.b").values, std::vector<double>({0.5, 1, 1.5}));
    EXPECT_EQ(columnOf(table, "old.a").values, std::vector<double>(3, 5));
    EXPECT_EQ(columnOf(table, "old.time").values, std::vector<double>({0, 1.000001, 2.000002}));
}

std::string imuDefinition() {
    return "std_msgs/Header header\ngeometry_msgs/Quaternion orientation\nfloat64[9] orientation_covariance\n"
           "geometry_msgs/Vector3 angular_velocity\nfloat64[9] angular_velocity_covariance\n"
           "geometry_msgs/Vector3 linear_acceleration\nfloat64[9] linear_acceleration_covariance\n"
           "====\nMSG: geometry_msgs/Quaternion\nfloat64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n"
           "====\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n"
           "====\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n"
           "====\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n";
}

std::string imu(double yaw_rate, double ax, double ay) {
    std::string cdr("\0\1\0\0", 4);
    cdr += u32(0) + u32(0) + u32(1) + std::string("\0\xEE\xEE\xEE", 4);  // no stamp, no frame
    for (const double q : {0., 0., 0., 1.}) cdr += doubleBytes(q, false);
    cdr += std::string(72, '\0');
    for (const double w : {0.01, 0.02, yaw_rate}) cdr += doubleBytes(w, false);
    cdr += std::string(72, '\0');
    for (const double a : {ax, ay, 9.81}) cdr += doubleBytes(a, false);
    return cdr + std::string(72, '\0');
}

// An IMU at 100 Hz, a speed in JSON at 20 Hz that begins 20 ms later, and a command.
std::string twoRates() {
    std::string records = schema(1, "sensor_msgs/msg/Imu", "ros2msg", imuDefinition()) +
                          channel(1, 1, "/imu/data", "cdr") + channel(2, 0, "/odom", "json") +
                          channel(3, 0, "/cmd_vel", "json") + channel(4, 0, "/camera", "protobuf");
    const std::uint64_t zero = 1'700'000'000'000'000'000, ms = 1'000'000;
    for (std::uint64_t i = 0; i <= 400; ++i) {
        const double t = 0.01 * static_cast<double>(i), rate = 0.3 * std::sin(t);
        records += message(3, zero + 10 * i * ms, R"({"twist":{"linear":{"x":99}}})");
        records += message(1, zero + 10 * i * ms, imu(rate, 1, 20 * rate));
        if (i % 5 == 2) {
            const std::string speed = std::to_string(20 + t);
            records += message(2, zero + 10 * i * ms,
                               R"({"twist":{"twist":{"linear":{"x":)" + speed +
                                   R"(,"y":0.0},"angular":{"z":7}},"covariance":[1,2]},"name":"a","on":true})");
        }
    }
    return mcapFile(chunk("zstd", zstd(records), records.size()) + message(4, zero, "picture"));
}

TEST(Mcap, TopicsOfSeveralRatesMeetOnTheDensest) {
    const ForeignTable table = tableOf(twoRates());
    EXPECT_EQ(columnOf(table, "/imu/data.angular_velocity.z").unit, "rad/s");
    EXPECT_EQ(columnOf(table, "/odom.twist.twist.linear.x").values.size(), 80u);
    EXPECT_EQ(columnOf(table, "/odom.on").values.at(0), 1);
    EXPECT_EQ(table.find("/odom.twist.covariance[0]"), nullptr);
    EXPECT_TRUE(says(table, "topic /camera: its messages are \"protobuf\", which tread does not read"));
    EXPECT_TRUE(says(table, "topic /imu/data: covariances and long arrays left out"));

    const GuessedMap guessed = guessMap(table);
    EXPECT_EQ(guessed.map.time.from, "/imu/data.time");
    std::map<std::string, std::string> from;
    for (const ImportChannel& one : guessed.map.map) from[one.channel] = one.from;
    EXPECT_EQ(from["chassis.yaw_rate"], "/imu/data.angular_velocity.z");
    EXPECT_EQ(from["chassis.ay"], "/imu/data.linear_acceleration.y");
    EXPECT_EQ(from["chassis.vx"], "/odom.twist.twist.linear.x") << "what the car does, not what it was told";
    const Imported result = importLog(table, guessed.map);
    const Log& log = result.logs.at(0);
    const std::string changes = tread::text(result.changes);
    EXPECT_NE(changes.find("chassis.vx, chassis.vy: interpolated from its own time \"/odom.time\""), std::string::npos)
        << changes;
    const std::vector<double>& vx = valuesOf(log, "chassis.vx");
    ASSERT_EQ(log.samples(), 396u) << "from the first to the last message of the later topic";
    for (std::size_t i = 0; i < vx.size(); ++i)
        ASSERT_NEAR(vx[i], 20.02 + 0.01 * static_cast<double>(i), 1e-6) << "a linear speed is interpolated exactly";
    EXPECT_NEAR(valuesOf(log, "chassis.yaw_rate")[98], 0.3 * std::sin(1.0), 1e-12);
    EXPECT_EQ(result.not_taken.end(), std::find(result.not_taken.begin(), result.not_taken.end(), "/odom.time"));
}

TEST(Mcap, AckermannMessagesAreKnown) {
    const std::string definition =
        "AckermannDrive drive\n====\nMSG: ackermann_msgs/AckermannDrive\nfloat32 steering_angle\n"
        "float32 steering_angle_velocity\nfloat32 speed\nfloat32 acceleration\nfloat32 jerk\n";
    std::string records =
        schema(1, "ackermann_msgs/msg/AckermannDriveStamped", "ros2msg", definition) + channel(1, 1, "/drive", "cdr");
    for (std::uint64_t i = 0; i < 100; ++i) {
        std::string cdr("\0\1\0\0", 4);
        for (const float value : {0.05f, 0.f, 8.f, 0.5f, 0.f}) cdr += u32(std::bit_cast<std::uint32_t>(value));
        records += message(1, i * 20'000'000, cdr);
    }
    std::vector<std::string> guesses;
    const ImportMap map = guessMap(tableOf(mcapFile(records)), guesses);
    std::map<std::string, std::string> from;
    for (const ImportChannel& one : map.map) from[one.channel] = one.from + " in " + one.unit;
    EXPECT_EQ(from["driver.steering_wheel_angle"], "/drive.drive.steering_angle in rad");
    EXPECT_EQ(from["chassis.vx"], "/drive.drive.speed in m/s");
    EXPECT_EQ(from["command.acceleration"], "/drive.drive.acceleration in m/s2");
    EXPECT_TRUE(std::any_of(guesses.begin(), guesses.end(), [](const std::string& guess) {
        return guess.find("may be the angle of the road wheels") != std::string::npos;
    }));
}

TEST(Mcap, StampsOfAnotherClockAreNotTaken) {
    std::string records = channel(1, 0, "/a", "json") + channel(2, 0, "/b", "json");
    for (std::uint64_t i = 0; i < 3; ++i) {
        const std::string stamp = R"({"header":{"stamp":{"sec":)" + std::to_string(5 + i) + R"(,"nanosec":0}},"v":1})";
        records +=
            message(1, 1'000'000'000'000 + i * 1'000, stamp) + message(2, 1'000'000'000'000 + i * 1'000, R"({"w":2})");
    }
    const ForeignTable table = tableOf(mcapFile(records));
    EXPECT_TRUE(says(table, "topic /a: its stamps are of another clock than those of logging (-995 s)"));
    EXPECT_EQ(columnOf(table, "/b.w").time, "/a.time") << "equal times are one column";
    EXPECT_EQ(columnOf(table, "/a.time").values, std::vector<double>({0, 1e-6, 2e-6}));
}

// A block with a match that overlaps itself and a long literal, and a stored one, as the format describes them.
TEST(Mcap, ChunksInLz4AreRead) {
    const std::string topic = channel(1, 0, "/a", "json");
    std::string records = topic;
    for (int i = 0; i < 3; ++i) records += message(1, i, R"({"vvvvvvvvvvvvvvvvvvvvvvvvvvvvvvvv":1})");
    const std::size_t run = records.find("vvvv"), length = 32;
    const std::string front = records.substr(0, run + 1), behind = records.substr(run + length);
    ASSERT_LT(front.size(), 15u + 255);
    ASSERT_GE(front.size(), 15u);
    std::string block = std::string("\xFF", 1) + static_cast<char>(front.size() - 15) + front;  // long literal
    block += u16(1) + static_cast<char>(length - 1 - 4 - 15);                                   // 1 back, 31 bytes
    block += std::string("\x50", 1) + behind.substr(0, 5);  // a block ends with literals
    const std::string stored = behind.substr(5), head = u32(0x184D2204) + std::string("\x60\x40\x82", 3);
    const auto lz4 = [&](const std::string& end) {
        return head + u32(block.size()) + block + u32(0x80000000 | stored.size()) + stored + end;
    };
    const ForeignTable table = tableOf(mcapFile(chunk("lz4", lz4(u32(0)), records.size(), sumOf(records))));
    EXPECT_EQ(columnOf(table, "/a." + std::string(length, 'v')).values, std::vector<double>({1, 1, 1}));
    EXPECT_TRUE(says(tableOf(mcapFile(topic + message(1, 9, R"({"v":1})") + chunk("lz4", lz4(""), records.size()))),
                     "1 chunk was damaged and left out"));
}

TEST(Mcap, UnorderedAndRepeatedMessagesAreSorted) {
    std::string records = channel(1, 0, "/a", "json");
    for (const int t : {3, 1, 2, 2}) records += message(1, t, R"({"v":)" + std::to_string(t) + "}");
    records += message(1, 9, "{\"v\":") + message(8, 9, "{}");
    const ForeignTable table = tableOf(mcapFile(records));
    EXPECT_EQ(columnOf(table, "/a.v").values, std::vector<double>({1, 2, 3}));
    EXPECT_TRUE(says(table, "topic /a: 1 message with a repeated time dropped"));
    EXPECT_TRUE(says(table, "topic /a: 1 message that cannot be read left out"));
    EXPECT_TRUE(says(table, "1 message of unknown topics left out"));
}

// ---- Damaged, hostile and other files -------------------------------------------------------------------------------

TEST(Mcap, CutOffRecordingGivesWhatIsThere) {
    const Log log = driveOf(4000);
    const std::string file = written(log);
    std::vector<std::size_t> places;
    for (const Record& one : recordsOf(file, 8, file.size() - 8)) {
        if (places.empty() || one.opcode == 6 || one.opcode == 7 || one.opcode == 15) {
            places.push_back(one.begin);
            places.push_back((one.begin + one.end) / 2);
        }
    }
    std::size_t most = 0;
    for (const std::size_t place : places) {
        try {
            const ForeignTable table = tableOf(file.substr(0, place));
            EXPECT_TRUE(says(table, "cut off")) << place;
            const std::vector<double>& vx = columnOf(table, "chassis.vx").values;
            EXPECT_GE(vx.size(), most) << place;
            most = vx.size();
            EXPECT_TRUE(std::equal(vx.begin(), vx.end(), log.channels[1].values.begin()));
        } catch (const LoadError& error) {
            EXPECT_EQ(most, 0u);
            EXPECT_NE(std::string(error.what()).find("holds no numbers that tread reads"), std::string::npos);
        }
    }
    EXPECT_EQ(most, log.samples());
    EXPECT_NE(faultsOf([&] { tableOf(file.substr(0, 5)); }).find("x.mcap: is not an MCAP file"), std::string::npos);
}

TEST(Mcap, EveryRecordMayBeTheLast) {
    const std::string file = twoRates();
    for (const Record& one : recordsOf(file, 8, file.size() - 8))
        fuzz::importHostile([&] { return tableOf(file.substr(0, one.begin)); });
    const std::string inside = written(driveOf(40));
    for (std::size_t size = 0; size < inside.size(); size += 7)
        fuzz::importHostile([&] { return tableOf(inside.substr(0, size)); });
}

TEST(Mcap, DamagedBytesEndInALogOrAFault) {
    std::string records =
        schema(7, "probes/msg/Probe", "ros2msg", kProbe) + channel(3, 7, "/probe", "cdr") + channel(4, 0, "/j", "json");
    for (std::uint32_t i = 0; i < 12; ++i)
        records += message(3, 1'000'000'000'000 + i, probe(i % 2 == 0, 1000 + i, 0, i)) +
                   message(4, i, R"({"vx":[1,{"a":2}],"header":{"stamp":{"sec":1,"nsec":5}}})");
    const std::string files[] = {mcapFile(records), mcapFile(chunk("", records, records.size())), written(driveOf(20))};
    std::mt19937 random(1);
    for (int round = 0; round < 600; ++round) {
        std::string damaged = files[round % 3];
        for (int i = 0; i <= round % 4; ++i) {
            const std::size_t at = random() % damaged.size();
            damaged[at] = random() % 2 ? static_cast<char>(random()) : static_cast<char>(random() % 2 ? 0 : 0xFF);
        }
        fuzz::importHostile([&] { return tableOf(damaged); });
    }
}

TEST(Mcap, HostileSizesAreRefused) {
    const std::string topic = channel(1, 0, "/a", "json") + message(1, 1, R"({"v":1})");
    EXPECT_TRUE(says(tableOf(mcapFile(topic + chunk("zstd", zstd("x"), std::uint64_t{1} << 60))),
                     "1 chunk was left out, with a claim of more than 256 MB"));
    const std::string bomb = zstd(std::string(1 << 20, '\0'));
    EXPECT_TRUE(says(tableOf(mcapFile(topic + chunk("zstd", bomb, 100))), "1 chunk was damaged and left out"));
    EXPECT_TRUE(
        says(tableOf(mcapFile(topic + chunk("bz2", "packed", 100))), "1 chunk was left out, packed with \"bz2\""));

    // A sequence that claims more elements than there are bytes, and types that contain themselves.
    const std::string definition = "float64[] a";
    EXPECT_TRUE(says(tableOf(mcapFile(topic + schema(1, "a/A", "ros2msg", definition) + channel(2, 1, "/s", "cdr") +
                                      message(2, 1, std::string("\0\1\0\0\xFF\xFF\xFF\xFF", 8)))),
                     "topic /s: 1 message that cannot be read left out"));
    EXPECT_TRUE(says(tableOf(mcapFile(topic + schema(1, "a/A", "ros2msg", "A[] a") + channel(2, 1, "/s", "cdr") +
                                      message(2, 1, "x"))),
                     "topic /s: its definition has types in types without an end"));
    EXPECT_TRUE(says(tableOf(mcapFile(topic + schema(1, "a/A", "ros2msg", "Other a") + channel(2, 1, "/s", "cdr") +
                                      message(2, 1, "x"))),
                     "topic /s: its definition does not say what \"Other\" is"));
}

TEST(Mcap, OtherRecordingsAreToldHowToBeConverted) {
    const Scratch scratch;
    const auto fault = [&](const std::string& name, const std::string& bytes) {
        return faultsOf([&] { readForeignTable(scratch.file(name, bytes)); });
    };
    EXPECT_NE(fault("a.mf4", "MDF     4.10").find("asammdf"), std::string::npos);
    EXPECT_NE(fault("drive.dat", "MDF     3.30").find("asammdf"), std::string::npos);
    EXPECT_NE(fault("drive.bag", "#ROSBAG V2.0\n").find("`mcap convert drive.bag drive.mcap`"), std::string::npos);
    EXPECT_NE(fault("drive.db3", "SQLite format 3").find("`ros2 bag convert`"), std::string::npos);
    EXPECT_NE(fault("drive.mcap", "time,vx\n0,1\n").find("is not an MCAP file"), std::string::npos);
}

}  // namespace
}  // namespace tread::mcap_test
