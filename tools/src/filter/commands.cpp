// SPDX-License-Identifier: MIT
// lumi filter and `lumi render --filter`: a network that makes the pictures of one field more like their path-traced
// references. The plug-in's door: nothing includes it.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>

#include "commands/scene_options.h"
#include "draw/draw_surface.h"
#include "files/output_file.h"
#include "filter/drawing.h"
#include "filter/lessons.h"
#include "filter/training.h"
#include "filter/weights_file.h"
#include "program/option_checks.h"
#include "program/plugin.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

constexpr char kKept[] = "the truths that were traced are kept for the next call; earlier output is untouched";

struct FilterOptions {
    SceneOptions scene;
    std::string field, output;
    bool json = false;
    filter::LessonSettings lessons;
    filter::TrainingSettings training;
};

// A field of the scene has the sphere that is fitted to it.
void require_of_scene(const FieldFile& field, const baker::Scene& scene, const std::string& path)
{
    const auto bits = [](float v) {
        uint32_t word = 0;
        std::memcpy(&word, &v, sizeof word);
        return word;
    };
    const auto centre = scene.centre();
    const std::array<uint32_t, 4> sphere = {bits(centre[0]), bits(centre[1]), bits(centre[2]), bits(scene.radius())};
    if (filter::subject_of(field).sphere != sphere)
        throw Failure(field.path(), "was not baked from " + path + ": their spheres differ", "give the field's scene");
}

filter::Lessons lessons_of(const FilterOptions& options, const FieldFile& field, const baker::Scene& scene)
{
    print(stderr, "truths of %d views, kept in %s\n", options.lessons.views, options.lessons.cache.c_str());
    ProgressPrinter printer(stderr, stderr_is_terminal());
    return filter::lessons_of(field, scene, options.lessons, watch(printer));
}

// Shows how far the training is, by the pace of its steps.
class TrainingProgress
{
public:
    filter::TrainingWatch watch()
    {
        return {[this](uint64_t seen, uint64_t all) { return step(seen, all); },
                [](const filter::EpochReport& report) { tell(report); }};
    }

private:
    bool step(uint64_t seen, uint64_t all)
    {
        baker::Progress progress;
        progress.stage = baker::Stage::training;
        progress.rays_done = seen;
        progress.rays_total = all;
        progress.elapsed_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        meter_.add(progress.elapsed_seconds, seen);
        progress.eta_seconds = meter_.eta_seconds(all);
        return lumi::tools::watch(printer_)(progress);
    }
    static void tell(const filter::EpochReport& report)
    {
        if (stderr_is_terminal()) return;  // the bar says enough
        print(stderr, "epoch %d of at most %d: %.3f dB; best %.3f, drawn %.3f\n", report.epoch, report.epochs,
              report.validation_db, report.best_db, report.drawn_db);
    }

    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    baker::RateMeter meter_{60};
    ProgressPrinter printer_{stderr, stderr_is_terminal()};
};

filter::TrainingResult trained(const FilterOptions& options, filter::Trainer& trainer, const filter::Lessons& lessons)
{
    TrainingProgress progress;
    return filter::train(trainer, lessons.training, lessons.validation, options.training, progress.watch());
}

void print_result(const FilterOptions& options, const filter::TrainingResult& result, const filter::Verdict& verdict)
{
    if (options.json) {
        print(stdout, "%s", filter::json_of(verdict).c_str());
        return;
    }
    if (!result.gains)
        print(stdout, "%s keeps the drawn pictures: no epoch made them better\n", options.output.c_str());
    print(stdout, "%d epochs; on views that it did not learn from:\n%s", result.epochs, text_of(verdict).c_str());
}

void run(FilterOptions& options)
{
    announce_outputs({options.output});
    if (options.lessons.cache.empty()) options.lessons.cache = options.output + ".truths";
    options.lessons.threads = options.scene.threads;
    options.training.seed = options.lessons.seed;
    filter::Module& module = filter::load_module();
    const FieldFile field(options.field);
    field.require_intact();
    size_t warnings = 0;
    const baker::Scene scene = load_scene(options.scene, warnings);
    require_of_scene(field, scene, options.scene.path);
    filter::Weights weights = {filter::subject_of(field), filter::input_planes(field), false, {}};
    weights.subject.scene = scene.fingerprint();
    const filter::Lessons lessons = lessons_of(options, field, scene);
    const auto trainer = module.trainer(weights.input_planes, options.lessons.seed);
    filter::TrainingResult result = trained(options, *trainer, lessons);
    trainer->set_numbers(result.numbers);
    std::optional<Waiting> waiting(std::in_place, "judging the filter");
    const filter::Verdict verdict = filter::verdict_on(result.gains ? trainer.get() : nullptr, lessons.test);
    weights.gains = result.gains;
    weights.numbers = result.numbers;
    write_output(options.output, filter::encode(weights));
    waiting.reset();
    print_result(options, result, verdict);
}

void add_lesson_options(CLI::App& command, FilterOptions& options)
{
    constexpr int kLeastViews = 3, kMostViews = 10000, kLeastSide = 32, kMostSide = 1024, kMostEpochs = 10000;
    command
        .add_option(
            "--views", options.lessons.views,
            "Views: 85 % to learn from, 8 % to tell when to stop, 7 % to be judged by, as in the LumiPath paper")
        ->check(whole_number(kLeastViews, kMostViews))
        ->type_name("COUNT")
        ->capture_default_str();
    command.add_option("--side", options.lessons.side_px, "Width and height of a view, pixels")
        ->check(whole_number(kLeastSide, kMostSide))
        ->type_name("PX")
        ->capture_default_str();
    command
        .add_option("--spp", options.lessons.samples,
                    "Light paths per pixel of the truths to learn from; the others have four times as many")
        ->check(whole_number(1, 1 << 16))
        ->type_name("S")
        ->capture_default_str();
    command.add_option("--epochs", options.training.epochs, "Times that each view is seen, at most")
        ->check(whole_number(1, kMostEpochs))
        ->type_name("E")
        ->capture_default_str();
    command.add_option("--seed", options.lessons.seed, "Seed of the random numbers")
        ->type_name("K")
        ->check(whole_number(0, UINT64_MAX))
        ->capture_default_str();
    command.add_option("--cache", options.lessons.cache, "Folder of truths, kept for the next call [WEIGHTS.truths]")
        ->type_name("DIR");
}

void add_train(CLI::App& filter)
{
    auto options = std::make_shared<FilterOptions>();
    CLI::App* command = filter.add_subcommand("train", "Train a filter for the pictures of one field");
    command->add_option("FIELD", options->field, "A field file of the scene")->required();
    add_scene_options(*command, options->scene);
    add_thread_option(*command, options->scene);
    command->add_option("-o,--output", options->output, "Weights to write")->type_name("WEIGHTS")->required();
    command->add_flag("--json", options->json, "Print what the filter does to views as JSON");
    add_lesson_options(*command, *options);
    command->footer(
        "The filter is for this field alone; `lumi render --filter` refuses others. It stops when pictures of other "
        "views get no better, and keeps the drawn picture if they never do. The bytes are the same in every run.\n"
        "Example:\n  lumi filter train product.lumi product.obj -o product.filter\n"
        "  lumi render product.lumi -o product.png --filter product.filter");
    command->callback([options] {
        try {
            run(*options);
        } catch (const baker::Cancelled&) {
            throw Interrupted(kKept);
        }
    });
}

struct JudgeOptions {
    SceneOptions scene;
    std::string weights, field, cache = "lumi-report";
    bool json = false;
    int views = quality::kHeldOutViews;
    uint32_t samples = 256;
    bool force = false;
};

filter::Trial trial_of(const JudgeOptions& options, const FieldFile& field, const baker::Scene& scene)
{
    const auto views = quality::held_out_views(quality::ViewSet::all, options.views);
    print(stderr, "truths of %d views, kept in %s\n", options.views, options.cache.c_str());
    ProgressPrinter printer(stderr, stderr_is_terminal());
    filter::Trial trial;
    trial.references = quality::references_of(scene, views, {options.samples, 1, options.scene.threads}, options.cache,
                                              watch(printer));
    for (const quality::HeldOutView& view : views) trial.drawn.push_back(filter::drawn_planes(field, view.eye));
    return trial;
}

void judge(const JudgeOptions& options)
{
    const FieldFile field(options.field);
    field.require_intact();
    const filter::Weights weights = filter::read_weights(options.weights);
    filter::require_fitting(weights, options.weights, field, options.force);
    std::unique_ptr<filter::Network> network;
    if (weights.gains) network = filter::load_module().network(weights.input_planes, weights.numbers);
    size_t warnings = 0;
    const baker::Scene scene = load_scene(options.scene, warnings);
    require_of_scene(field, scene, options.scene.path);
    const filter::Trial trial = trial_of(options, field, scene);
    std::optional<Waiting> waiting(std::in_place, "judging the filter");
    const filter::Verdict verdict = filter::verdict_on(network.get(), trial);
    waiting.reset();
    print(stdout, "%s", (options.json ? filter::json_of(verdict) : text_of(verdict)).c_str());
}

void add_judge(CLI::App& filter)
{
    auto options = std::make_shared<JudgeOptions>();
    CLI::App* command = filter.add_subcommand("judge", "Measure what a filter does to the views of lumi report");
    command->add_option("WEIGHTS", options->weights, "Weights that lumi filter train wrote")->required();
    command->add_option("FIELD", options->field, "The field that they are for")->required();
    add_scene_options(*command, options->scene);
    add_thread_option(*command, options->scene);
    constexpr int kMaxViews = 100;
    command->add_option("--count", options->views, "Number of views")
        ->check(whole_number(1, kMaxViews))
        ->type_name("COUNT")
        ->capture_default_str();
    command->add_option("--spp", options->samples, "Light paths per pixel of the truths")
        ->check(whole_number(1, 1 << 16))
        ->type_name("S")
        ->capture_default_str();
    command->add_option("--cache", options->cache, "Folder of truths, that of lumi report")
        ->type_name("DIR")
        ->capture_default_str();
    command->add_flag("--json", options->json, "Print the figures as JSON");
    command->add_flag("--force-filter", options->force, "Judge the weights on another field, too");
    command->callback([options] {
        try {
            judge(*options);
        } catch (const baker::Cancelled&) {
            throw Interrupted(kKept);
        }
    });
}

// The picture with the change from `before` to `after`. These lie over a colour by a rounding of their own.
Picture changed_like(Picture picture, const Picture& before, const Picture& after)
{
    for (size_t i = 0; i < picture.rgb.size(); ++i)
        picture.rgb[i] = static_cast<uint8_t>(std::clamp(picture.rgb[i] + after.rgb[i] - before.rgb[i], 0, 255));
    return picture;
}

// `lumi render --filter`.
class FilterStage : public PictureStage
{
public:
    void add_options(CLI::App& render) override
    {
        render
            .add_option("--filter", weights_,
                        "Weights that lumi filter train wrote for this field: what they make of the picture")
            ->type_name("WEIGHTS");
        render.add_flag("--force-filter", force_, "Use them for another field too, though they harm other scenes");
    }

    Drawer changed(const RenderOptions& options, const FieldFile& file, Drawer drawer) const override
    {
        if (weights_.empty()) return drawer;
        require_filterable(options, file);
        const filter::Weights weights = filter::read_weights(weights_);
        filter::require_fitting(weights, weights_, file, force_);
        if (!weights.gains) return drawer;
        const std::shared_ptr<filter::Network> network =
            filter::load_module().network(weights.input_planes, weights.numbers);
        const Eye* filtered = nullptr;  // the planes show it: over another colour it need not be filtered again
        filter::Planes before, after;
        return [&file, drawer, network, filtered, before, after](const Eye& eye, const Rgb8& background) mutable {
            if (filtered != &eye) after = network->filtered(before = filter::drawn_planes(file, eye));
            filtered = &eye;
            return changed_like(drawer(eye, background), filter::over(before, background),
                                filter::over(after, background));
        };
    }

private:
    // A filter has learned from pictures of the best mode, as they are before a display takes them.
    static void require_filterable(const RenderOptions& options, const FieldFile& file)
    {
        constexpr int kMostSide = 2048;  // the network needs some hundred bytes a pixel
        const std::string best = file.is_surface() ? name_of(SurfaceMode::two_by_two) : "linear";
        if (options.mode != "best" && options.mode != best)
            throw UsageError("--filter takes --mode best, not " + options.mode);
        if (!options.views.photo.empty() || options.drawing.span_px > 1 ||
            options.drawing.display != DisplayFormat::rgb888)
            throw UsageError("--filter goes with none of --span, --pixel and --over");
        if (options.views.width_px > kMostSide || options.views.height_px > kMostSide)
            throw UsageError("--filter takes a --size of at most " + std::to_string(kMostSide) + "x" +
                             std::to_string(kMostSide));
    }

    std::string weights_;
    bool force_ = false;
};

void add_filter(CLI::App& lumi)
{
    CLI::App* filter = lumi.add_subcommand("filter", "Learned filters: pictures of one field, closer to the truth");
    filter->require_subcommand(1);
    filter->footer("Example:\n  lumi filter train product.lumi product.obj -o product.filter");
    add_train(*filter);
    add_judge(*filter);
}

std::shared_ptr<PictureStage> make_stage()
{
    return std::make_shared<FilterStage>();
}

const bool kRegistered = (plugins().push_back({add_filter, make_stage}), true);

}  // namespace

}  // namespace lumi::tools
