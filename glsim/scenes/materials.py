"""The named materials of the literature.

Source: the table of material properties that came with the OpenGL Programming Guide's sample program ``teapots``
(Silicon Graphics, 1993), measured by eye for the fixed-function lighting model.  Per material: ambient k_a,
diffuse k_d, specular k_s (RGB) and the exponent n (128 times the table's shininess).
"""

from __future__ import annotations

from glsim.machine.state import Face
from glsim.names import did_you_mean

_TABLE = """
emerald          .0215 .1745 .0215        .07568 .61424 .07568     .633 .727811 .633         76.8
jade             .135 .2225 .1575         .54 .89 .63              .316228 .316228 .316228   12.8
obsidian         .05375 .05 .06625        .18275 .17 .22525        .332741 .328634 .346435   38.4
pearl            .25 .20725 .20725        1 .829 .829              .296648 .296648 .296648   11.264
ruby             .1745 .01175 .01175      .61424 .04136 .04136     .727811 .626959 .626959   76.8
turquoise        .1 .18725 .1745          .396 .74151 .69102       .297254 .30829 .306678    12.8
brass            .329412 .223529 .027451  .780392 .568627 .113725  .992157 .941176 .807843   27.8974
bronze           .2125 .1275 .054         .714 .4284 .18144        .393548 .271906 .166721   25.6
polished-bronze  .25 .148 .06475          .4 .2368 .1036           .774597 .458561 .200621   76.8
chrome           .25 .25 .25              .4 .4 .4                 .774597 .774597 .774597   76.8
copper           .19125 .0735 .0225       .7038 .27048 .0828       .256777 .137622 .086014   12.8
polished-copper  .2295 .08825 .0275       .5508 .2118 .066         .580594 .223257 .0695701  51.2
gold             .24725 .1995 .0745       .75164 .60648 .22648     .628281 .555802 .366065   51.2
polished-gold    .24725 .2245 .0645       .34615 .3143 .0903       .797357 .723991 .208006   83.2
pewter           .105882 .058824 .113725  .427451 .470588 .541176  .333333 .333333 .521569   9.84615
silver           .19225 .19225 .19225     .50754 .50754 .50754     .508273 .508273 .508273   51.2
polished-silver  .23125 .23125 .23125     .2775 .2775 .2775        .773911 .773911 .773911   89.6
black-plastic    0 0 0                    .01 .01 .01              .5 .5 .5                  32
cyan-plastic     0 .1 .06                 0 .509804 .509804        .501961 .501961 .501961   32
green-plastic    0 0 0                    .1 .35 .1                .45 .55 .45               32
red-plastic      0 0 0                    .5 0 0                   .7 .6 .6                  32
white-plastic    0 0 0                    .55 .55 .55              .7 .7 .7                  32
yellow-plastic   0 0 0                    .5 .5 0                  .6 .6 .5                  32
black-rubber     .02 .02 .02              .01 .01 .01              .4 .4 .4                  10
cyan-rubber      0 .05 .05                .4 .5 .5                 .04 .7 .7                 10
green-rubber     0 .05 0                  .4 .5 .4                 .04 .7 .04                10
red-rubber       .05 0 0                  .5 .4 .4                 .7 .04 .04                10
white-rubber     .05 .05 .05              .5 .5 .5                 .7 .7 .7                  10
yellow-rubber    .05 .05 0                .5 .5 .4                 .7 .7 .04                 10
"""


def _parse(line: str) -> tuple[str, Face]:
    name, *words = line.split()
    values = list(map(float, words))
    ambient, diffuse, specular = ((*values[k : k + 3], 1.0) for k in (0, 3, 6))
    return name, Face(ambient, diffuse, specular, shininess=values[9])  # type: ignore[arg-type]


MATERIALS: dict[str, Face] = dict(map(_parse, _TABLE.strip().splitlines()))


def material(name: str) -> Face:
    """A material by name: "brass", "polished gold", ...  Raises ValueError that lists the names."""
    key = name.lower().replace(" ", "-").replace("_", "-")
    if key not in MATERIALS:
        raise ValueError(
            f"there is no material {name!r}; the names are {', '.join(MATERIALS)}{did_you_mean(key, MATERIALS)}"
        )
    return MATERIALS[key]
