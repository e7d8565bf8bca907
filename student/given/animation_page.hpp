// The page that render writes, without its data: head, style and body around a script that draws
// `animation` = {l, dt, delta, q, motion, right}. q is three rows; motion is {m, g, v}, or null if
// velocities aren't known; right is another q to compare with, or null. The page loads nothing
// else.
#pragma once

#include <string_view>

#include "animation_picture.hpp"
#include "animation_plots.hpp"
#include "animation_reader.hpp"
#include "animation_square.hpp"
#include "animation_style.hpp"

namespace bounce {

inline constexpr std::string_view page_head = R"html(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="bounce">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<link rel="icon" href="data:,">
<title>Bouncing square</title>
)html";

inline constexpr std::string_view page_body = R"html(<body>
<main>
<header>
<h1>Bouncing square</h1>
<p id="about"></p>
</header>
<figure>
<canvas id="stage" role="img" aria-label="The square on its way over the ground. The numbers below say where it is."></canvas>
<figcaption>The line follows the lowest corner and breaks where another one takes over; dots mark contact, <i>&phi;</i> &lt; <i>&delta;</i>. Faint squares are equal times apart.<span id="forces"> The arrow is the force of the ground, <i>f<sub>t</sub></i> along it and <i>f<sub>n</sub></i> away from it.</span><span id="other"> The dashed square is the right one; <span id="parted"></span>.</span></figcaption>
</figure>
<dl id="numbers">
<div><dt><i>t</i>, time</dt><dd><span id="time"></span> <small>s</small></dd></div>
<div><dt><i>x</i>, centre</dt><dd><span id="x"></span> <small>m</small></dd></div>
<div><dt><i>y</i>, centre</dt><dd><span id="y"></span> <small>m</small></dd></div>
<div><dt><i>&theta;</i>, angle</dt><dd><span id="theta"></span> <small>rad</small></dd></div>
<div id="tangential"><dt><i>f<sub>t</sub></i>, along</dt><dd><span id="f_t"></span> <small>N</small></dd></div>
<div id="normal"><dt><i>f<sub>n</sub></i>, away</dt><dd><span id="f_n"></span> <small>N</small></dd></div>
<div><dt><i>&phi;</i>, lowest corner</dt><dd><span id="phi"></span> <small>m<span id="contact">, contact</span></small></dd></div>
</dl>
<div id="controls">
<button id="play" type="button"><svg viewBox="0 0 20 20" aria-hidden="true"><path></path></svg></button>
<input id="slider" type="range" min="0" value="0" step="1" aria-label="Time step">
<output id="column" for="slider" aria-live="off"></output>
<label>Speed
<select id="speed">
<option value="0.125">1/8&times;</option>
<option value="0.25">1/4&times;</option>
<option value="0.5">1/2&times;</option>
<option value="1">1&times;</option>
<option value="2">2&times;</option>
<option value="fit">10 s a loop</option>
</select></label>
<label id="choice"><input id="compare" type="checkbox" checked> Show the right one</label>
</div>
<figure id="beside">
<canvas id="plots" role="img" aria-label="The height phi of the lowest corner and the energies over time. The upright line is the time that is shown."></canvas>
</figure>
<p id="hint">Space plays and pauses, the arrows go one step, Home and End to the first and the last<span id="key">, C shows and hides the right one</span>. The plots can be dragged.</p>
<a id="more" href="#numbers" hidden>More below &darr;</a>
<noscript>The animation needs JavaScript, which is turned off in this browser.</noscript>
</main>
)html";

}  // namespace bounce
