// SPDX-License-Identifier: MIT
// How the trade looks on the report page: chart and pictures side by side where there is room.
#pragma once

namespace lumi::trade
{

inline constexpr char kTradeStyle[] = R"(
:root { --surface: #2a6fc9; --chord: #c8641b; --beaten: #8889; }
@media (prefers-color-scheme: dark) { :root { --surface: #6ea8ff; --chord: #f0924a; } }
.part { border: 1px solid var(--line); border-radius: 10px; padding: 0.2rem 1rem 1rem; margin: 1rem 0; }
.part h2 { margin-top: 0.7rem; }
.answer { font-size: 1.1rem; max-width: none; }
.part pre { overflow-x: auto; background: var(--soft); border-radius: 6px; padding: 0.5rem 0.7rem; margin: 0.5rem 0;
  font-size: 0.85rem; }
.sides { display: grid; grid-template-columns: minmax(0, 11fr) minmax(0, 9fr); gap: 1rem; align-items: start; }
.thumbs { display: grid; grid-template-columns: repeat(auto-fill, minmax(108px, 1fr)); gap: 0.5rem; }
.thumbs .best { outline: 3px solid var(--surface); }
.sides svg { display: block; width: 100%; height: auto; font: 13px system-ui, sans-serif; fill: currentColor; }
svg .grid { stroke: var(--line); }
svg .pace { stroke: currentColor; stroke-dasharray: 4 4; opacity: 0.6; }
svg .stairs { fill: none; stroke: currentColor; opacity: 0.45; }
svg .end { text-anchor: end; }
svg .mid { text-anchor: middle; }
svg .name { font-weight: 700; stroke: Canvas; stroke-width: 3px; paint-order: stroke; }
svg .beaten { fill: none; stroke: var(--beaten); }
svg .surface { fill: var(--surface); fill-opacity: 0.75; stroke: var(--surface); }
svg .chord { fill: var(--chord); fill-opacity: 0.75; stroke: var(--chord); }
svg .best { stroke: currentColor; stroke-width: 3px; }
.legend i.surface { background: var(--surface); border-radius: 50%; }
.legend i.chord { background: var(--chord); border-radius: 50%; }
.legend i.beaten { border: 1px solid var(--beaten); border-radius: 50%; box-sizing: border-box; }
tr.beaten td { color: GrayText; }
@media (max-width: 760px) {
  .part { padding: 0.1rem 0.6rem 0.7rem; }
  .sides { grid-template-columns: minmax(0, 1fr); }
  .sides svg { font-size: 18px; }
  .thumbs { grid-template-columns: repeat(3, 1fr); }
}
)";

}  // namespace lumi::trade
