-- tries to describe itself anew
-- expect: harmless
interaction { name = 'Dynamics <- Other', calls = 'Population' }
