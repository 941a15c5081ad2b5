// SPDX-License-Identifier: MIT
#include "bench/measure.h"

#include <algorithm>
#include <map>
#include <memory>

#include "bench/boards.h"
#include "bench/host_renderer.h"
#include "bench/judge.h"
#include "bench/surface.h"
#include "files/field_file.h"
#include "terminal/failure.h"
#include "terminal/interrupt.h"

namespace lumi::bench
{
namespace
{

// A program of the bench firmware and the spans that it is run with.
struct Program {
    std::string mode, texel, renderer;
    std::vector<int> spans;
};

std::vector<Program> programs_of(const Matrix& matrix)
{
    std::vector<int> spans = matrix.spans;
    spans.erase(std::remove(spans.begin(), spans.end(), 0), spans.end());
    const bool exact = spans.size() != matrix.spans.size();
    std::vector<Program> programs;
    for (const std::string& mode : matrix.modes) {
        if (is_surface(mode)) continue;
        for (const std::string& texel : matrix.texels) {
            if (exact && mode != "dither" && mode != "voronoi")
                programs.push_back({mode, texel, "exact_" + mode + "_" + texel, {0}});
            if (!spans.empty()) programs.push_back({mode, texel, "spans_" + mode + "_" + texel, spans});
        }
    }
    return programs;
}

const View& view_called(const std::string& name)
{
    return *std::find_if(
        std::begin(kViews), std::end(kViews), [&](const View& view) { return view.name == name; });
}

class Measurement
{
public:
    Measurement(const Settings& settings, const Announce& announce) : settings_(settings), announce_(announce) {}

    Results run()
    {
        std::filesystem::create_directories(settings_.work);
        const std::vector<Program> programs = programs_of(settings_.matrix);
        if (programs.empty()) return {};
        for (const std::string& texel : settings_.matrix.texels) {
            announce_("field, " + texel);
            fields_.try_emplace(texel, require_field(settings_.field, texel, settings_.work).string());
        }
        for (const std::string& core : settings_.matrix.cores) run_core(core, programs);
        return std::move(results_);
    }

private:
    void run_core(const std::string& core, const std::vector<Program>& programs)
    {
        announce_(core + ": building " + std::to_string(programs.size()) + " renderers");
        const Board board(core, settings_.source, settings_.work);
        std::vector<std::string> renderers;
        for (const Program& program : programs) renderers.push_back(program.renderer);
        board.build(renderers);
        for (const Program& program : programs) run_program_on(board, core, program);
    }

    void run_program_on(const Board& board, const std::string& core, const Program& program)
    {
        announce_(core + ": " + program.renderer);
        const uint32_t code_bytes = board.code_bytes(program.renderer);
        const tools::FieldFile& file = fields_.at(program.texel);
        for (const Count& count : board.count(program.renderer, file.path(), settings_.matrix.views, program.spans)) {
            tools::leave_if_interrupted();
            const HostFacts& host = facts(program, count);
            if (host.crc != count.crc)
                throw tools::Failure(program.renderer,
                                     core + " draws other bits than this machine, view " + count.view + ", span " +
                                         std::to_string(count.span),
                                     "build both from the same source");
            results_.push_back({core, program.mode, program.texel, count, code_bytes, host.accuracy, host.traffic});
        }
    }

    const HostFacts& facts(const Program& program, const Count& count)
    {
        const auto [at, is_new] = facts_.try_emplace(program.renderer + count.view + std::to_string(count.span));
        if (!is_new) return at->second;
        const tools::FieldFile& file = fields_.at(program.texel);
        const View& view = view_called(count.view);
        Camera camera;
        if (make_view_camera(view, camera) != CameraError::none) return at->second;
        const HostFrame frame = draw_on_host(program.mode, count.span, file.field(), file.bytes(), camera);
        if (!judge_) judge_ = std::make_unique<Judge>(file.field());
        at->second = {judge_->judge(program.mode, count.span, file.field(), view, frame.picture),
                      traffic_of(frame.reads), frame.rgb565_crc};
        return at->second;
    }

    const Settings& settings_;
    const Announce& announce_;
    std::map<std::string, tools::FieldFile> fields_;
    std::map<std::string, HostFacts> facts_;
    std::unique_ptr<Judge> judge_;
    Results results_;
};

}  // namespace

Results measure(const Settings& settings, const Announce& announce)
{
    return Measurement(settings, announce).run();
}

}  // namespace lumi::bench
