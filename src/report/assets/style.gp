# Shared by all figures of this folder. Redraw one with: gnuplot NAME.gp
# Colours of Okabe and Ito, which people of any colour vision tell apart.
set encoding utf8
set linetype 1 lc rgb "#0072B2" lw 1.6
set linetype 2 lc rgb "#D55E00" lw 1.6
set linetype 3 lc rgb "#009E73" lw 1.6
set linetype 4 lc rgb "#CC79A7" lw 1.6
set linetype 5 lc rgb "#E69F00" lw 1.6
set linetype 6 lc rgb "#56B4E9" lw 1.6
set linetype 7 lc rgb "#000000" lw 1.6
# Further runs take the colours once more, dashed and dotted.
set linetype 8 lc rgb "#0072B2" lw 1.6 dt 2
set linetype 9 lc rgb "#D55E00" lw 1.6 dt 2
set linetype 10 lc rgb "#009E73" lw 1.6 dt 2
set linetype 11 lc rgb "#CC79A7" lw 1.6 dt 2
set linetype 12 lc rgb "#E69F00" lw 1.6 dt 2
set linetype 13 lc rgb "#56B4E9" lw 1.6 dt 2
set linetype 14 lc rgb "#000000" lw 1.6 dt 2
set linetype 15 lc rgb "#0072B2" lw 1.6 dt 3
set linetype 16 lc rgb "#D55E00" lw 1.6 dt 3
set linetype 17 lc rgb "#009E73" lw 1.6 dt 3
set linetype 18 lc rgb "#CC79A7" lw 1.6 dt 3
set linetype 19 lc rgb "#E69F00" lw 1.6 dt 3
set linetype 20 lc rgb "#56B4E9" lw 1.6 dt 3
set linetype 21 lc rgb "#000000" lw 1.6 dt 3
set linetype cycle 21
set border 3 lw 0.8 lc rgb "#222222"
set tics nomirror out scale 0.6
set key top right samplen 1.8 spacing 1.15
