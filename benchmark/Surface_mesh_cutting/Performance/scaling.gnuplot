# Time and memory against the size, from the sizes.csv that performance.py writes:
#
#   gnuplot -e "file='sizes.csv'" scaling.gnuplot
#
# Writes scaling.png, a figure of the manual, and scaling.svg. The exponents are fitted between 10,000 and 1,000,000 triangles.
set datafile separator ","
set terminal pngcairo size 640,420 font "sans-serif,10" background "white"
set output "scaling.png"
set logscale xy
set format x "10^{%L}"
set xlabel "triangles"
set ylabel "CPU seconds"
set grid
set key top left
set xrange [1500:1500000]

power(x) = c + k * x
k = 1
c = -10
fit [log(9000):log(1100000)] power(x) file using (log(column("triangles"))):(log(column("total_s"))) via k, c
total = k
fit [log(9000):log(1100000)] power(x) file using (log(column("triangles"))):(log(column("cut_s"))) via k, c
plot file using (column("triangles")):(column("total_s")) with linespoints pointtype 7 linewidth 2 \
       title sprintf("cut and UVs, exponent %.2f", total), \
     file using (column("triangles")):(column("cut_s")) with linespoints pointtype 6 linewidth 2 \
       title sprintf("cut alone, exponent %.2f", k)
set terminal svg size 640,420 font "sans-serif,12" background rgb "white"
set output "scaling.svg"
replot
