// SPDX-License-Identifier: MIT
// Learned filters through the program. But for the last test, none of it needs libtorch.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "filter/weights_file.h"
#include "image/picture_file.h"
#include "support/program.h"
#include "support/small_surface.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"

namespace lumi::tools
{

namespace
{

namespace fs = std::filesystem;
using test::Arguments;
using test::joined;
using test::lumi;
using test::Outcome;

struct FilterShop {
    test::TemporaryFolder folder;
    std::string scene = test::write_cube(folder.path()), field = folder / "s.lumi", weights = folder / "w.filter";

    FilterShop() { test::write_content(field, test::small_surface_bytes()); }

    // For that field: idle, or with a network of zeros.
    void write_weights(bool gains) const
    {
        filter::Weights w;
        w.subject = filter::subject_of(FieldFile(field));
        w.input_planes = filter::kSurfacePlanes;
        w.gains = gains;
        if (gains) w.numbers.assign(filter::number_count(w.input_planes), 0);
        test::write_content(weights, filter::encode(w));
    }
    Outcome render(Arguments more, const std::string& output = "o.png", const std::string& size = "40x40") const
    {
        more.insert(more.begin(), {"render", field, "-o", folder / output, "--size", size});
        return lumi(more);
    }
};

// The program where no module lies beside it.
Outcome lumi_without_module(const test::TemporaryFolder& folder, Arguments arguments)
{
    fs::create_directory(folder / "bin");
    fs::copy_file(LUMI_PROGRAM, folder / "bin/lumi");
    arguments.insert(arguments.begin(), folder / "bin/lumi");
    return test::run_program(arguments);
}

}  // namespace

#ifdef LUMI_FAULT_SHIM
TEST_CASE("where /proc is missing, no module is loaded from the working directory")
{
    const test::TemporaryFolder folder;
    for (const char* module : {"lumi_openvdb.so", "lumi_filter.so"}) test::write_content(folder / module, "no module");
    test::write_content(folder / "a.vdb", "no volume");
    check_refused(test::run_program({"env", "--chdir=" + folder.path(), "LD_PRELOAD=" LUMI_FAULT_SHIM,
                                     "LUMI_FAULT=link:1", LUMI_PROGRAM, "reference", "a.vdb", "-o", "o.png"}),
                  1, Catch::Contains("/proc/self/exe") && !Catch::Contains("does not load"));
}
#endif

TEST_CASE("without libtorch, training and filtering say what to install, and leave earlier output")
{
    const std::string mend = "install libtorch (Debian: libtorch-dev), then configure and build lumi again";
    const auto check = [&](const FilterShop& shop, const std::string& output, const Arguments& call) {
        test::write_content(output, "earlier");
        check_refused(lumi_without_module(shop.folder, call), 1, "lumi was built without its learned filter; " + mend);
        CHECK(test::content_of(output) == "earlier");
    };
    const FilterShop training, filtering;
    check(training, training.weights, {"filter", "train", training.field, training.scene, "-o", training.weights});
    filtering.write_weights(true);
    check(filtering, filtering.folder / "o.png",
          {"render", filtering.field, "-o", filtering.folder / "o.png", "--filter", filtering.weights});
}

TEST_CASE("weights that gain nothing leave the picture as it is drawn")
{
    const FilterShop shop;
    shop.write_weights(false);
    REQUIRE(shop.render({}).code == 0);
    REQUIRE(shop.render({"--filter", shop.weights}, "f.png").code == 0);
    CHECK(test::content_of(shop.folder / "f.png") == test::content_of(shop.folder / "o.png"));
}

TEST_CASE("render refuses weights that are missing, damaged or another field's")
{
    const FilterShop shop;
    shop.write_weights(false);
    test::write_content(shop.folder / "cut.filter", test::content_of(shop.weights).substr(0, 100));
    test::write_content(shop.folder / "c.lumi", test::field_bytes({}));
    const std::vector<std::pair<Arguments, std::string>> calls = {
        {{shop.field, "--filter", shop.folder / "none"}, "cannot be read"},
        {{shop.field, "--filter", shop.folder / "cut.filter"}, "train it again"},
        {{shop.field, "--filter", shop.field}, "holds no weights of a filter"},
        {{shop.folder / "c.lumi", "--filter", shop.weights}, "is a chord field"},
    };
    for (const auto& [call, hint] : calls) {
        check_refused(lumi(joined({"render", "-o", shop.folder / "o.png"}, call)), 1, hint);
        CHECK_FALSE(fs::exists(shop.folder / "o.png"));
    }
}

TEST_CASE("a filter takes pictures of the best mode only")
{
    const FilterShop shop;
    shop.write_weights(false);
    for (const Arguments& more : {Arguments{"--mode", "one-sample"}, {"--pixel", "rgb565"}})
        check_refused(shop.render(joined({"--filter", shop.weights}, more)), 2, "--filter");
    CHECK(shop.render({"--filter", shop.weights, "--mode", "2x2"}).code == 0);
}

#ifdef LUMI_TEST_TRAINING
TEST_CASE("training makes pictures of unseen views more alike, the same bytes each time, another scene is refused")
{
    const FilterShop shop;
    const Arguments call = {
        "filter", "train", shop.field, shop.scene, "--sky",    "gradient", "--views", "80",
        "--side", "48",    "--spp",    "32",       "--epochs", "20",       "--cache", shop.folder / "cache"};
    std::string told;
    const auto trained = [&](const std::string& name) {
        Arguments all = call;
        all.insert(all.end(), {"-o", shop.folder / name, "--json"});
        const test::Outcome outcome = done(lumi(all));
        told = outcome.out;
        return test::content_of(shop.folder / name);
    };
    CHECK((trained("w.filter") == trained("again.filter")));
    const auto json = nlohmann::json::parse(told);
    CHECK(json["filtered"]["psnr_db"].get<double>() > json["drawn"]["psnr_db"].get<double>());
    REQUIRE(shop.render({}).code == 0);
    REQUIRE(shop.render({"--filter", shop.weights}, "f.png").code == 0);
    CHECK(test::content_of(shop.folder / "f.png") != test::content_of(shop.folder / "o.png"));
    check_refused(lumi({"filter", "train", shop.field, test::kScene, "-o", shop.weights}), 1, "their spheres differ");
}

TEST_CASE("a network of zeros returns what it is given, at every size")
{
    const FilterShop shop;
    shop.write_weights(true);
    for (const char* size : {"33x47", "8x8"}) {
        REQUIRE(shop.render({}, "o.png", size).code == 0);
        REQUIRE(shop.render({"--filter", shop.weights}, "f.png", size).code == 0);
        CHECK(read_png(shop.folder / "f.png").rgb == read_png(shop.folder / "o.png").rgb);
    }
}
#endif

}  // namespace lumi::tools
