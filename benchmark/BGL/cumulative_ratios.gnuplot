# Cumulative distributions of the ratios to the shortest tree, from the output of connect_random_terminals
# (paper, Figure 18).
set datafile separator ","
set terminal svg size 640,420
set output "cumulative_ratios.svg"
set xlabel "length / shortest length"
set ylabel "part of the sets"
set xrange [1:1.15]
set yrange [0:1]
set key bottom right
file = "ratios.csv"
stats file using 4 every ::1 nooutput
n = STATS_records
plot file every ::1 using ($7/$15):(1./n) smooth cumulative title "MST", \
     file every ::1 using ($9/$15):(1./n) smooth cumulative title "SPH", \
     file every ::1 using ($11/$15):(1./n) smooth cumulative title "greedy", \
     file every ::1 using ($13/$15):(1./n) smooth cumulative title "local search"
