-- tries to loop by goto
-- expect: limit
::again::
goto again
