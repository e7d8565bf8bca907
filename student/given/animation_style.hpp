// The page's colours and layout.
#pragma once

#include <string_view>

namespace bounce {

// With every kind of colour vision, one can tell blue, vermilion, bluish green and reddish purple
// apart (Okabe and Ito's palette, darker or lighter for contrast). Dashes and words repeat the
// information.
inline constexpr std::string_view page_style = R"css(<style>
:root {
  --paper: #f6f5f1; --card: #ffffff; --text: #22252a; --quiet: #646a73; --edge: #dcdad3; --grid: rgba(0, 0, 0, 0.07);
  --ground: #e6e3da; --ground-line: #77746b; --square: #0072b2; --corner: #c84f00; --force: #007a5a; --right: #a8437f;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #121417; --card: #1a1d21; --text: #e8e6e1; --quiet: #a0a5ad; --edge: #33373d; --grid: rgba(255, 255, 255, 0.08);
    --ground: #2b2f34; --ground-line: #8b8f96; --square: #56b4e9; --corner: #f0a040; --force: #2fc79b; --right: #e79ac8;
  }
}
* { box-sizing: border-box; margin: 0; }
body {
  background: var(--paper); color: var(--text); accent-color: var(--square);
  font: 15px/1.45 system-ui, -apple-system, "Segoe UI", Roboto, sans-serif;
}
main {
  display: flex; flex-direction: column; gap: 14px; min-height: 100vh; min-height: 100dvh;
  max-width: 2400px; margin: 0 auto; padding: 20px 24px;
}
header { display: flex; flex-wrap: wrap; align-items: baseline; gap: 0 16px; }
h1 { font-size: 21px; font-weight: 650; letter-spacing: -0.01em; }
header p, figcaption, dt, small, #hint { color: var(--quiet); font-size: 13px; }
#more {
  position: fixed; right: 10px; bottom: 10px; padding: 4px 12px; border-radius: 14px;
  background: var(--text); color: var(--paper); font-size: 13px; text-decoration: none;
}
i { font-family: "STIX Two Text", Cambria, Georgia, "Times New Roman", serif; font-size: 1.1em; }
figure { display: flex; flex-direction: column; gap: 8px; }
figure:first-of-type { flex: 1 0 auto; }
#stage {
  flex: 1 0 0px; width: 100%; min-height: 240px; cursor: pointer;
  background: var(--card); border: 1px solid var(--edge); border-radius: 12px;
}
#plots { width: 100%; height: 230px; cursor: crosshair; touch-action: pan-y; background: var(--card); border: 1px solid var(--edge); border-radius: 12px; }
#compare { width: 18px; height: 18px; vertical-align: -3px; }
[hidden] { display: none !important; }
sub { line-height: 0; }
dl { --unit: 40px; display: grid; grid-template-columns: repeat(auto-fit, minmax(calc(var(--longest, 6) * 1ch + var(--unit)), 1fr)); gap: 6px 12px; font-size: 19px; }
dt, dd { white-space: nowrap; }
dd, output { font-variant-numeric: tabular-nums; }
#controls { display: flex; flex-wrap: wrap; align-items: center; gap: 8px 16px; }
#play {
  width: 46px; height: 46px; padding: 0; border: 0; border-radius: 50%; cursor: pointer;
  background: var(--square); color: var(--card);
}
#play svg { display: block; width: 20px; height: 20px; margin: auto; fill: currentColor; }
#slider { flex: 1; min-width: 70%; height: 32px; margin: 0; cursor: pointer; }
output { text-align: right; }
select {
  height: 38px; margin-left: 4px; padding: 0 8px; font: inherit; color: inherit;
  background: var(--card); border: 1px solid var(--edge); border-radius: 8px;
}
:focus-visible { outline: 3px solid var(--corner); outline-offset: 2px; }
@media (pointer: coarse), (max-width: 640px) { #hint { display: none; } }
@media (min-width: 641px) { #slider { min-width: 0; } }
/* On a wide screen the plots stand beside the stage, and both fill the page. */
@media (min-width: 1200px) and (min-height: 521px) {
  main { display: grid; grid-template: auto 1fr auto auto auto / minmax(0, 2fr) minmax(420px, 1fr); }
  header, dl, #controls, #hint { grid-column: 1 / -1; }
  figure { grid-row: 2; }
  #beside { grid-column: 2; }
  #plots { flex: 1 0 230px; height: 0; }
}
/* On a phone the square, what moves it and the plots come first; words and numbers follow. */
@media (max-width: 640px) {
  main { padding: 10px 14px; gap: 10px; }
  h1 { font-size: 18px; }
  figure { display: contents; }
  #stage { flex-basis: 220px; min-height: 220px; }
  #plots { flex: none; height: 200px; }
  #controls, #plots { order: 1; }
  #controls { justify-content: space-between; gap: 4px 16px; }
  #numbers { --unit: 30px; order: 2; font-size: 16px; }
  figcaption { order: 3; }
  output { text-align: left; }
}
@media (max-height: 520px) {
  main { padding: 12px; gap: 8px; }
  header { position: absolute; clip-path: inset(50%); }
  figcaption, #hint { display: none; }
  #stage { min-height: 160px; }
}
</style>
</head>
)css";

}  // namespace bounce
