-- tries to loop by jumps over the beginnings of loops
-- expect: limit
::top::
do
  if true then goto bottom end
  for i = 1, 2 do end
end
::bottom::
goto top
