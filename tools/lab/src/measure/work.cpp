// SPDX-License-Identifier: MIT
// lumi-lab work: what the planner's model counts of the bench's frames, and what it makes of that.
#include <cmath>
#include <memory>

#include "files/field_file.h"
#include "lumi/bench/surface_modes.h"
#include "measure/commands.h"
#include "planner/unit_costs.h"
#include "planner/work.h"
#include "terminal/failure.h"

namespace lumi::lab
{

namespace
{

using Json = nlohmann::ordered_json;

struct Options {
    std::vector<std::string> fields;
    std::vector<int> spans = {0, 4, 8, 16};
    int rows = 16, first = 0, poses = 0;
};

constexpr std::pair<const char*, tools::Mode> kModes[] = {
    {"nearest", tools::Mode::nearest}, {"linear", tools::Mode::linear}, {"paper", tools::Mode::paper}};

void put_work(Json& row, const planner::FrameWork& work)
{
    for (const char* core : planner::kCountedCores)
        row["modelled"][core] = std::round(planner::instructions_of(core, work));
    for (size_t k = 0; k < work.done.size(); ++k) row["counts"][planner::kUnitCosts[k].unit] = work.done[k];
}

tools::Eye eye_of(const Pose& pose, const Image& image)
{
    tools::Eye eye = {pose, image, {}};
    (void)make_camera(pose, image, eye.camera);  // the bench's views have one
    return eye;
}

void add_surface(Json& rows, const tools::FieldFile& file, const Json& view, const tools::Eye& eye, int32_t stripe_rows)
{
    for (const bench::NamedSurfaceMode& mode : bench::kSurfaceModes) {
        tools::leave_if_interrupted();
        Json row = {{"view", view}, {"mode", mode.name}, {"rows", stripe_rows}};
        put_work(row, planner::work_of(file.surface(), eye, mode.mode, stripe_rows).frame);
        rows.push_back(row);
    }
}

void add_chord(Json& rows, const tools::FieldFile& file, const Json& view, const tools::Eye& eye,
               const Options& options)
{
    for (const auto& [name, mode] : kModes)
        for (const int span : options.spans) {
            if (span != 0 && !planner::is_drawn_by_spans(file.field(), mode, span)) continue;
            tools::leave_if_interrupted();
            Json row = {{"view", view}, {"mode", name}, {"span", span}};
            put_work(row, planner::frame_of(file.field(), mode, span, eye.camera, options.rows).work);
            rows.push_back(row);
        }
}

void run(const Options& options)
{
    Json fields;
    for (const std::string& path : options.fields) {
        const tools::FieldFile file(path);
        file.require_intact();
        Json rows = Json::array();
        const auto add = [&](const Json& view, const Pose& pose, const Image& image) {
            const tools::Eye eye = eye_of(pose, image);
            if (file.is_surface())
                add_surface(rows, file, view, eye, options.rows);
            else
                add_chord(rows, file, view, eye, options);
        };
        if (options.poses == 0)
            for (const bench::View& view : bench::kViews)
                add(view.name, bench::view_pose(view), bench::view_image(view));
        for (int k = options.first; k < options.poses; ++k) {
            const bench::PosedView view = bench::posed_view(static_cast<uint32_t>(k));
            add(k, view.pose, view.image);
        }
        fields[path] = rows;
    }
    print(fields);
}

}  // namespace

void add_work(CLI::App& lab)
{
    auto options = std::make_shared<Options>();
    CLI::App* command = lab.add_subcommand("work", "Tell what the model of instructions counts of the bench's frames");
    command->add_option("FIELD", options->fields, "Fields of either layout")->required();
    command->add_option("--rows", options->rows, "Scanlines of a stripe [16]");
    command->add_option("--span", options->spans, "Spans of chord fields [0,4,8,16]")->delimiter(',');
    command->add_option("--poses", options->poses, "The first so many of the bench's poses, in place of its views");
    command->add_option("--first", options->first, "The first pose [0]");
    command->callback([options] { run(*options); });
}

}  // namespace lumi::lab
