// SPDX-License-Identifier: MIT
#include "planner/plan_report.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "terminal/text.h"

namespace lumi::planner
{

namespace
{

using nlohmann::json;

template <class... Values>
std::string formatted(const char* format, Values... values)
{
    char text[400];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::string quality_text(const Measurement& m)
{
    std::string text =
        formatted("%.2f dB, SSIM %.4f, ", m.psnr_db, m.ssim) + tools::byte_text(m.bytes) + "; drawn by mode " + m.mode;
    if (m.rate) text += formatted(", about %.1f frames/s", *m.rate);
    return text;
}

std::string alternative_line(const Alternative& other)
{
    const Measurement& m = other.measurement;
    if (!m.works) return formatted("  %-30s %s", other.what.c_str(), m.note.c_str());
    return formatted("  %-30s %+6.2f dB  %8s", other.what.c_str(), other.difference_db,
                     tools::byte_text(m.bytes).c_str());
}

std::string outlook_line(uint64_t budget, const std::optional<Measurement>& m, const Measurement& best)
{
    const std::string name = "with " + tools::byte_text(budget) + ": ";
    if (!m) return name + "nothing works\n";
    return name + formatted("%+.2f dB by ", m->psnr_db - best.psnr_db) + text_of(m->plan) + "\n";
}

json json_of(const Measurement& m)
{
    json object = {{"works", m.works},
                   {"layout", "chord"},
                   {"plan", text_of(m.plan)},
                   {"bytes", m.bytes},
                   {"options", options_of(m.plan)},
                   {"note", m.note}};
    if (m.works) {
        object["psnr_db"] = m.psnr_db;
        object["ssim"] = m.ssim;
        object["mode"] = m.mode;
    }
    if (m.rate) object["frames_per_second"] = *m.rate;
    return object;
}

json json_or_null(const std::optional<Measurement>& m)
{
    return m ? json_of(*m) : json(nullptr);
}

std::string dumped(const json& value, int indent)
{
    return value.dump(indent, ' ', false, json::error_handler_t::replace);
}

}  // namespace

std::string text_of(const Result& result)
{
    const Measurement& best = result.best;
    std::string text =
        "plan for " + tools::byte_text(result.task.budget_bytes) + ", views " + quality::name_of(result.task.views) +
        ": " + std::to_string(result.tried.size()) + " trials in " + tools::duration_text(result.seconds) + ", " +
        std::to_string(result.settings.views) + " views, " + std::to_string(result.settings.samples) +
        " light paths a texel" + (result.exhausted ? " (all that were allowed)" : "") + "\n  " + text_of(best.plan) +
        "\n  " + quality_text(best) + "\n  by hand: " + options_of(best.plan) + "\n";
    if (!result.alternatives.empty()) text += "dropped, each measured in the same budget:\n";
    for (const Alternative& other : result.alternatives) text += alternative_line(other) + "\n";
    if (result.half || result.twice) {
        text += outlook_line(result.task.budget_bytes / 2, result.half, best);
        text += outlook_line(result.task.budget_bytes * 2, result.twice, best);
    }
    return text;
}

std::string json_of(const Result& result)
{
    json tried = json::array(), dropped = json::array();
    for (const Measurement& m : result.tried) tried.push_back(json_of(m));
    for (const Alternative& other : result.alternatives) {
        json object = json_of(other.measurement);
        object["what"] = other.what;
        if (other.measurement.works) object["difference_db"] = other.difference_db;
        dropped.push_back(object);
    }
    const json object = {{"budget_bytes", result.task.budget_bytes},
                         {"views", quality::name_of(result.task.views)},
                         {"measured_views", result.settings.views},
                         {"samples_per_texel", result.settings.samples},
                         {"seconds", result.seconds},
                         {"trials_spent", result.exhausted},
                         {"chosen", json_of(result.best)},
                         {"dropped", dropped},
                         {"half", json_or_null(result.half)},
                         {"twice", json_or_null(result.twice)},
                         {"tried", tried}};
    return dumped(object, 2) + "\n";
}

std::string text_of(const PlanProgress& at)
{
    if (at.last == nullptr) return "planning: at least " + std::to_string(at.left) + " trials";
    std::string text = "trial " + std::to_string(at.done) + ", at least " + std::to_string(at.left) + " more, about " +
                       tools::duration_text(at.eta_seconds) + ": " + text_of(at.last->plan) + ": " +
                       (at.last->works ? formatted("%.2f dB", at.last->psnr_db) : at.last->note);
    if (at.best != nullptr) text += formatted(" (best %.2f)", at.best->psnr_db);
    return text;
}

std::string json_of(const PlanProgress& at)
{
    json object = {{"state", "planning"},
                   {"trials_done", at.done},
                   {"trials_left", at.left},
                   {"elapsed_seconds", at.elapsed_seconds},
                   {"eta_seconds", at.eta_seconds < 0 ? json(nullptr) : json(at.eta_seconds)},
                   {"best_psnr_db", at.best == nullptr ? json(nullptr) : json(at.best->psnr_db)}};
    return dumped(object, -1);
}

}  // namespace lumi::planner
