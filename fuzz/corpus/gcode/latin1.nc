(Tasche fräsen, 2 mm tief)
G21 G90
G0 X10 Y0
G1 Y10 F300 ; längs
M30
