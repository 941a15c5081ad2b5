// SPDX-License-Identifier: MIT
// lumi-lab frames: what this machine can say about the frames that boards draw.
#include <algorithm>
#include <memory>

#include "bench/frame_facts.h"
#include "files/field_file.h"
#include "files/field_report.h"
#include "lumi/chord/texel.h"
#include "measure/commands.h"
#include "terminal/interrupt.h"

namespace lumi::lab
{

namespace
{

using Json = nlohmann::ordered_json;

struct Options {
    std::vector<std::string> fields, modes, pixels = {"rgb565", "rgb888"}, views;
    std::vector<int> spans;
};

bool is_asked_for(const std::vector<std::string>& words, const char* word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

void put_facts(Json& row, const bench::FrameFacts& facts)
{
    row["psnr_db"] = hundredths(facts.accuracy.psnr_db);
    row["psnr_all_db"] = hundredths(facts.accuracy.psnr_all_db);
    row["worst_pixel"] = facts.accuracy.worst_pixel;
    row["crc"] = facts.crc;
    for (size_t i = 0; i < planner::kChips; ++i) {
        const std::string key = planner::kChipList[i].key;
        row["lines_" + key] = facts.traffic[i].lines;
        row["misses_" + key] = facts.traffic[i].misses;
    }
}

void add_chord_rows(const tools::FieldFile& file, const Options& options, bench::Judge& judge, const bench::View& view,
                    Json& rows)
{
    for (const std::string& mode : options.modes) {
        for (const int span : options.spans) {
            tools::leave_if_interrupted();
            Json row = {{"texel", detail::texel_name(file.field().texel_format)},
                        {"mode", mode},
                        {"span", span},
                        {"view", view.name}};
            put_facts(row, bench::chord_facts(judge, file, mode, span, view));
            rows.push_back(row);
        }
    }
}

void add_surface_rows(const tools::FieldFile& file, const Options& options, const bench::View& view, Json& rows)
{
    for (const bench::NamedSurfaceMode& mode : bench::kSurfaceModes) {
        if (!is_asked_for(options.modes, mode.name)) continue;
        for (const std::string& pixel : options.pixels) {
            tools::leave_if_interrupted();
            Json row = {{"mode", mode.name},
                        {"pixel", pixel},
                        {"view", view.name},
                        {"triangles", tools::triangles_of(file.surface())},
                        {"vertices", file.surface().vertex_count},
                        {"see_through_patches", file.surface().see_through_count}};
            if (file.surface().see_through_count != 0)
                row["crc"] = bench::surface_crc(file, mode, pixel, view);
            else
                put_facts(row, bench::surface_facts(file, mode, pixel, view));
            rows.push_back(row);
        }
    }
}

void run(const Options& options)
{
    Json rows = Json::array();
    std::unique_ptr<bench::Judge> judge;
    for (const std::string& path : options.fields) {
        const tools::FieldFile file(path);
        file.require_intact();
        if (!file.is_surface() && !judge) judge = std::make_unique<bench::Judge>(file.field());
        for (const bench::View& view : bench::kViews) {
            if (!is_asked_for(options.views, view.name)) continue;
            if (file.is_surface())
                add_surface_rows(file, options, view, rows);
            else
                add_chord_rows(file, options, *judge, view, rows);
        }
    }
    print(rows);
}

}  // namespace

void add_frames(CLI::App& lab)
{
    auto options = std::make_shared<Options>();
    CLI::App* command = lab.add_subcommand("frames", "Tell CRC, accuracy and flash lines of the bench's frames");
    command->add_option("FIELD", options->fields, "Fields; chord fields of one pair of lattices")->required();
    command->add_option("--mode", options->modes, "Modes of either layout")->delimiter(',')->required();
    command->add_option("--span", options->spans, "Spans of chord fields, 0 for exact drawing")->delimiter(',');
    command->add_option("--pixel", options->pixels, "Pixels of surface fields")->delimiter(',');
    command->add_option("--view", options->views, "generic, pole, close")->delimiter(',')->required();
    command->callback([options] { run(*options); });
}

}  // namespace lumi::lab
