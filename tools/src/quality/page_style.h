// SPDX-License-Identifier: MIT
// How the report page looks: one column on a phone, pictures side by side where there is room.
#pragma once

namespace lumi::quality
{

inline constexpr char kPageStyle[] = R"(
:root { color-scheme: light dark; --line: #8884; --soft: #8882; }
body { font: 16px/1.45 system-ui, sans-serif; margin: 0 auto; padding: 0.8rem; max-width: 1560px; }
h1 { font-size: 1.35rem; margin: 0.4rem 0; overflow-wrap: anywhere; }
h2 { font-size: 1.1rem; margin: 1.6rem 0 0.4rem; }
h3 { font-size: 0.95rem; margin: 1rem 0 0.3rem; }
p { margin: 0.4rem 0; max-width: 46rem; }
.wide { overflow-x: auto; }
table { border-collapse: separate; border-spacing: 0; font-variant-numeric: tabular-nums; font-size: 0.88rem; }
th, td { padding: 0.25rem 0.6rem; border-bottom: 1px solid var(--line); text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; position: sticky; left: 0; background: Canvas; }
td:first-child { white-space: normal; overflow-wrap: anywhere; min-width: 7rem; max-width: 16rem; }
.views { display: grid; grid-template-columns: repeat(auto-fit, minmax(160px, 1fr)); gap: 0.5rem; align-items: start; }
.views .pair { grid-column: span 2; display: grid; grid-template-columns: 1fr 1fr; column-gap: 0.5rem; }
.pair figcaption { grid-column: 1 / -1; }
@media (max-width: 500px) {
  table { font-size: 0.8rem; }
  th, td { padding: 0.25rem 0.3rem; }
  .views { grid-template-columns: repeat(2, 1fr); }
  .views figure:first-child { grid-column: 1 / -1; display: grid; grid-template-columns: 1fr 1fr; column-gap: 0.5rem;
    align-items: center; }
}
figure { margin: 0; background: var(--soft); border-radius: 6px; overflow: hidden; }
figure img { display: block; width: 100%; height: auto; }
figcaption { padding: 0.3rem 0.5rem 0.45rem; font-size: 0.8rem; overflow-wrap: anywhere; }
.bar { display: flex; height: 1.1rem; border-radius: 4px; overflow: hidden; }
.bar span { min-width: 1px; }
.key { display: flex; flex-wrap: wrap; gap: 0.2rem 0.9rem; font-size: 0.82rem; margin-top: 0.25rem; }
.key i { display: inline-block; width: 0.75em; height: 0.75em; border-radius: 2px; margin-right: 0.35em; }
)";

}  // namespace lumi::quality
