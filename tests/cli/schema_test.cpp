#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "places/places.h"

namespace tread::schema_test {
namespace {

using Json = nlohmann::json;

TEST(SchemaCommand, PrintsJsonSchema) {
    for (const char* what : {"vehicle", "tyre", "scenario", "import", "tolerances", "envelope", "score"}) {
        const Result result = runProgram({"schema", what});
        EXPECT_EQ(result.status, 0) << what;
        EXPECT_EQ(result.err, "") << what;
        const Json json = Json::parse(result.out);
        EXPECT_EQ(json["$schema"], "http://json-schema.org/draft-07/schema#") << what;
        EXPECT_EQ(json["$id"], std::string(what) + ".schema.json");
        EXPECT_EQ(json["additionalProperties"], false) << "a misspelt key is an error";
    }
}

void expectFresh(const std::string& what, const std::string& file) {
    EXPECT_EQ(contentOf(sourceFile(file)), runProgram({"schema", what}).out)
        << "renew it with: tread schema " << what << " -o " << file;
}

TEST(SchemaCommand, ShippedSchemasAreFresh) {
    expectFresh("vehicle", "vehicles/vehicle.schema.json");
    expectFresh("tyre", "vehicles/tyres/tyre.schema.json");
    expectFresh("scenario", "scenarios/scenario.schema.json");
    expectFresh("import", "tools/import/import.schema.json");
    expectFresh("diagnosis", "scenarios/diagnose/diagnosis.schema.json");
    expectFresh("campaign", "scenarios/campaigns/campaign.schema.json");
    expectFresh("own_effects", "scenarios/diagnose/own_effects.schema.json");
}

// An editor finds the schema by the first line of the file.
TEST(SchemaCommand, ShippedFilesNameASchemaThatIsThere) {
    const std::string marker = "# yaml-language-server: $schema=";
    std::size_t files = 0;
    for (const std::string& folder : {sourceFile("vehicles"), sourceFile("scenarios")}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
            if (entry.path().extension() != ".yaml") continue;
            const std::string line = firstLine(contentOf(entry.path().string()));
            ASSERT_EQ(line.find(marker), 0u) << entry.path();
            const auto named = entry.path().parent_path() / line.substr(marker.size());
            EXPECT_TRUE(std::filesystem::exists(named)) << entry.path();
            ++files;
        }
    }
    EXPECT_GE(files, 10u);
}

TEST(SchemaCommand, WritesTheFileThatIsNamed) {
    const Scratch scratch;
    const std::string file = scratch.path("tyre.schema.json");
    const Result result = runProgram({"schema", "tyre", "-o", file});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(contentOf(file), runProgram({"schema", "tyre"}).out);
    EXPECT_EQ(scratch.names(), std::vector<std::string>{"tyre.schema.json"});
}

TEST(SchemaCommand, UnknownNameIsAnsweredWithASuggestionAndTheList) {
    const Result result = runProgram({"schema", "tolerance"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("tread: there is no kind of file \"tolerance\", only vehicle, tyre"), std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find("did you mean \"tolerances\"?"), std::string::npos) << result.err;
    EXPECT_EQ(runProgram({"schema", "log"}).status, 2) << "a log is CSV";
}

}  // namespace
}  // namespace tread::schema_test
