"use strict";(()=>{var ux="uplot",fx="u-hz",dx="u-vt",px="u-title",mx="u-wrap",gx="u-under",_x="u-over",xx="u-axis",Ks="u-off",vx="u-select",yx="u-cursor-x",bx="u-cursor-y",Mx="u-cursor-pt",wx="u-legend",Sx="u-live",Ex="u-inline",Tx="u-series",Ax="u-marker",gp="u-label",Cx="u-value",ta="width",na="height";var _p="bottom",Hr="left",ru="right",Mu="#000",xp=Mu+"0",ou="mousemove",vp="mousedown",au="mouseup",yp="mouseenter",bp="mouseleave",Mp="dblclick",Rx="resize",Ix="scroll",wp="change",wl="dppxchange",wu="--",Zr=typeof window<"u",fu=Zr?document:null,Wr=Zr?window:null,Px=Zr?navigator:null,Tt,vl;function du(){let n=devicePixelRatio;Tt!=n&&(Tt=n,vl&&mu(wp,vl,du),vl=matchMedia(`(min-resolution: ${Tt-.001}dppx) and (max-resolution: ${Tt+.001}dppx)`),js(wp,vl,du),Wr.dispatchEvent(new CustomEvent(wl)))}function Zn(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function pu(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Wt(n,e,t){n.style[e]=t+"px"}function xi(n,e,t,i){let s=fu.createElement(n);return e!=null&&Zn(s,e),t?.insertBefore(s,i),s}function hi(n,e){return xi("div",n,e)}var Sp=new WeakMap;function Ii(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Sp.get(n);r!=o&&(n.style.transform=r,Sp.set(n,r),e<0||t<0||e>i||t>s?Zn(n,Ks):pu(n,Ks))}var Ep=new WeakMap;function Tp(n,e,t){let i=e+t,s=Ep.get(n);i!=s&&(Ep.set(n,i),n.style.background=e,n.style.borderColor=t)}var Ap=new WeakMap;function Cp(n,e,t,i){let s=e+""+t,r=Ap.get(n);s!=r&&(Ap.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Su={passive:!0},Lx={...Su,capture:!0};function js(n,e,t,i){e.addEventListener(n,t,i?Lx:Su)}function mu(n,e,t,i){e.removeEventListener(n,t,Su)}Zr&&du();function vi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:Jn((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function nm(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var im=n=>n!=null,sm=n=>n!=null&&n>0,Tl=nm(im),Dx=nm(sm);function Ux(n,e,t,i=0,s=!1){let r=s?Dx:Tl,o=s?sm:im;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??kt,l??-kt]}function Al(n,e,t,i){let s=Pp(n),r=Pp(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Zi:rm,a=s==1?Jn:ui,l=r==1?ui:Jn,c=a(o(fn(n))),u=l(o(fn(e))),h=Xr(t,c),f=Xr(t,u);return t==10&&(c<0&&(h=Ot(h,-c)),u<0&&(f=Ot(f,-u))),i||t==2?(n=h*s,e=f*r):(n=cm(n,h),e=Cl(e,f)),[n,e]}function Eu(n,e,t,i){let s=Al(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Tu=.1,Rp={mode:3,pad:Tu},sa={pad:0,soft:null,mode:0},Fx={min:sa,max:sa};function Sl(n,e,t,i){return Rl(t)?Ip(n,e,t):(sa.pad=t,sa.soft=i?0:null,sa.mode=i?3:0,Ip(n,e,Fx))}function Mt(n,e){return n??e}function Nx(n,e,t){for(e=Mt(e,0),t=Mt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Ip(n,e,t){let i=t.min,s=t.max,r=Mt(i.pad,0),o=Mt(s.pad,0),a=Mt(i.hard,-kt),l=Mt(s.hard,kt),c=Mt(i.soft,kt),u=Mt(s.soft,-kt),h=Mt(i.mode,0),f=Mt(s.mode,0),d=e-n,_=Zi(d),v=Un(fn(n),fn(e)),m=Zi(v),p=fn(m-_);(d<1e-24||p>10)&&(d=0,(n==0||e==0)&&(d=1e-24,h==2&&c!=kt&&(r=0),f==2&&u!=-kt&&(o=0)));let T=d||v||1e3,S=Zi(T),b=Xr(10,Jn(S)),N=T*(d==0?n==0?.1:1:r),L=Ot(cm(n-N,b/10),24),D=n>=c&&(h==1||h==3&&L<=c||h==2&&L>=c)?c:kt,B=Un(a,L<D&&n>=D?D:yi(D,L)),E=T*(d==0?e==0?.1:1:o),M=Ot(Cl(e+E,b/10),24),I=e<=u&&(f==1||f==3&&M>=u||f==2&&M<=u)?u:-kt,q=yi(l,M>I&&e<=I?I:Un(I,M));return B==q&&B==0&&(q=100),[B,q]}var kx=new Intl.NumberFormat(Zr?Px.language:"en-US"),Au=n=>kx.format(n),Kn=Math,Ml=Kn.PI,fn=Kn.abs,Jn=Kn.floor,un=Kn.round,ui=Kn.ceil,yi=Kn.min,Un=Kn.max,Xr=Kn.pow,Pp=Kn.sign,Zi=Kn.log10,rm=Kn.log2,Ox=(n,e=1)=>Kn.sinh(n)*e,lu=(n,e=1)=>Kn.asinh(n/e),kt=1/0;function Lp(n){return(Zi((n^n>>31)-(n>>31))|0)+1}function gu(n,e,t){return yi(Un(n,e),t)}function om(n){return typeof n=="function"}function dt(n){return om(n)?n:()=>n}var Bx=()=>{},am=n=>n,lm=(n,e)=>e,zx=n=>null,Dp=n=>!0,Up=(n,e)=>n==e,Vx=/\.\d*?(?=9{6,}|0{6,})/gm,Qs=n=>{if(um(n)||bs.has(n))return n;let e=`${n}`,t=e.match(Vx);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Qs(s)}e${r}`}return Ot(n,i)};function Zs(n,e){return Qs(Ot(Qs(n/e))*e)}function Cl(n,e){return Qs(ui(Qs(n/e))*e)}function cm(n,e){return Qs(Jn(Qs(n/e))*e)}function Ot(n,e=0){if(um(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return un(i)/t}var bs=new Map;function hm(n){return((""+n).split(".")[1]||"").length}function oa(n,e,t,i){let s=[],r=i.map(hm);for(let o=e;o<t;o++){let a=fn(o),l=Ot(Xr(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:Ot(u,h);s.push(f),bs.set(f,h)}}return s}var ra={},Cu=[],qr=[null,null],ys=Array.isArray,um=Number.isInteger,Hx=n=>n===void 0;function Fp(n){return typeof n=="string"}function Rl(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Gx(n){return n!=null&&typeof n=="object"}var Wx=Object.getPrototypeOf(Uint8Array),fm="__proto__";function $r(n,e=Rl){let t;if(ys(n)){let i=n.find(s=>s!=null);if(ys(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=$r(n[s],e)}else t=n.slice()}else if(n instanceof Wx)t=n.slice();else if(e(n)){t={};for(let i in n)i!=fm&&(t[i]=$r(n[i],e))}else t=n;return t}function nn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=fm&&(Rl(n[s])?nn(n[s],$r(i[s])):n[s]=$r(i[s]))}return n}var Xx=0,qx=1,$x=2;function Yx(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function Zx(n,e){if(jx(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Qx(o[0])||(o=Kx(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:qx,d=[];for(let _=0;_<u.length;_++){let v=u[_],m=r.get(l[_]);v===null?f!=Xx&&(h[m]=v,f==$x&&d.push(m)):h[m]=v}Yx(h,d,s),i.push(h)}}return i}var Jx=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Kx(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function jx(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Qx(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Un(1,Jn((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var dm=["January","February","March","April","May","June","July","August","September","October","November","December"],pm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function mm(n){return n.slice(0,3)}var ev=pm.map(mm),tv=dm.map(mm),nv={MMMM:dm,MMM:tv,WWWW:pm,WWW:ev};function ea(n){return(n<10?"0":"")+n}function iv(n){return(n<10?"00":n<100?"0":"")+n}var sv={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>ea(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>ea(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>ea(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>ea(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>ea(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>iv(n.getMilliseconds())};function Ru(n,e){e=e||nv;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?sv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var rv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function ov(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==rv?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var gm=n=>n%1==0,El=[1,2,2.5,5],av=oa(10,-32,0,El),_m=oa(10,0,32,El),lv=_m.filter(gm),Js=av.concat(_m),Iu=`
`,xm="{YYYY}",Np=Iu+xm,vm="{M}/{D}",ia=Iu+vm,yl=ia+"/{YY}",ym="{aa}",cv="{h}:{mm}",Gr=cv+ym,kp=Iu+Gr,Op=":{ss}",Rt=null;function bm(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?oa(10,0,3,El).filter(gm):oa(10,-3,0,El)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,xm,Rt,Rt,Rt,Rt,Rt,Rt,1],[s*28,"{MMM}",Np,Rt,Rt,Rt,Rt,Rt,1],[s,vm,Np,Rt,Rt,Rt,Rt,Rt,1],[i,"{h}"+ym,yl,Rt,ia,Rt,Rt,Rt,1],[t,Gr,yl,Rt,ia,Rt,Rt,Rt,1],[e,Op,yl+" "+Gr,Rt,ia+" "+Gr,Rt,kp,Rt,1],[n,Op+".{fff}",yl+" "+Gr,Rt,ia+" "+Gr,Rt,kp,Rt,1]];function u(h){return(f,d,_,v,m,p)=>{let T=[],S=m>=o,b=m>=r&&m<o,N=h(_),L=Ot(N*n,3),D=cu(N.getFullYear(),S?0:N.getMonth(),b||S?1:N.getDate()),B=Ot(D*n,3);if(b||S){let E=b?m/r:0,M=S?m/o:0,I=L==B?L:Ot(cu(D.getFullYear()+M,D.getMonth()+E,1)*n,3),q=new Date(un(I/n)),z=q.getFullYear(),W=q.getMonth();for(let Y=0;I<=v;Y++){let $=cu(z+M*Y,W+E*Y,1),j=$-h(Ot($*n,3));I=Ot((+$+j)*n,3),I<=v&&T.push(I)}}else{let E=m>=s?s:m,M=Jn(_)-Jn(L),I=B+M+Cl(L-B,E);T.push(I);let q=h(I),z=q.getHours()+q.getMinutes()/t+q.getSeconds()/i,W=m/i,Y=f.axes[d]._space,$=p/Y;for(;I=Ot(I+m,n==1?0:3),!(I>v);)if(W>1){let j=Jn(Ot(z+W,6))%24,ce=h(I).getHours()-j;ce>1&&(ce=-1),I-=ce*i,z=(z+W)%24;let _e=T[T.length-1];Ot((I-_e)/m,3)*$>=.7&&T.push(I)}else T.push(I)}return T}}return[l,c,u]}var[hv,uv,fv]=bm(1),[dv,pv,mv]=bm(.001);oa(2,-53,53,[1]);function Bp(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function zp(n,e){return(t,i,s,r,o)=>{let a=e.find(_=>o>=_[0])||e[e.length-1],l,c,u,h,f,d;return i.map(_=>{let v=n(_),m=v.getFullYear(),p=v.getMonth(),T=v.getDate(),S=v.getHours(),b=v.getMinutes(),N=v.getSeconds(),L=m!=l&&a[2]||p!=c&&a[3]||T!=u&&a[4]||S!=h&&a[5]||b!=f&&a[6]||N!=d&&a[7]||a[1];return l=m,c=p,u=T,h=S,f=b,d=N,L(v)})}}function gv(n,e){let t=Ru(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function cu(n,e,t){return new Date(n,e,t)}function Vp(n,e){return e(n)}var _v="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Hp(n,e){return(t,i,s,r)=>r==null?wu:e(n(i))}function xv(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function vv(n,e){return n.series[e].fill(n,e)}var yv={show:!0,live:!0,isolate:!1,mount:Bx,markers:{show:!0,width:2,stroke:xv,fill:vv,dash:"solid"},idx:null,idxs:null,values:[]};function bv(n,e){let t=n.cursor.points,i=hi(),s=t.size(n,e);Wt(i,ta,s),Wt(i,na,s);let r=s/-2;Wt(i,"marginLeft",r),Wt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Wt(i,"borderWidth",o),i}function Mv(n,e){let t=n.series[e].points;return t._fill||t._stroke}function wv(n,e){let t=n.series[e].points;return t._stroke||t._fill}function Sv(n,e){return n.series[e].points.size}var hu=[0,0];function Ev(n,e,t){return hu[0]=e,hu[1]=t,hu}function bl(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function uu(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var Tv={show:!0,x:!0,y:!0,lock:!1,move:Ev,points:{one:!1,show:bv,size:Sv,width:0,stroke:wv,fill:Mv},bind:{mousedown:bl,mouseup:bl,click:bl,dblclick:bl,mousemove:uu,mouseleave:uu,mouseenter:uu},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Mm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Pu=nn({},Mm,{filter:lm}),wm=nn({},Pu,{size:10}),Sm=nn({},Mm,{show:!1}),Lu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Em="bold "+Lu,Tm=1.5,Gp={show:!0,scale:"x",stroke:Mu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Em,side:2,grid:Pu,ticks:wm,border:Sm,font:Lu,lineGap:Tm,rotate:0},Av="Value",Cv="Time",Wp={show:!0,scale:"x",auto:!1,sorted:1,min:kt,max:-kt,idxs:[]};function Rv(n,e,t,i,s){return e.map(r=>r==null?"":Au(r))}function Iv(n,e,t,i,s,r,o){let a=[],l=bs.get(s)||0;t=o?t:Ot(Cl(t,s),l);for(let c=t;c<=i;c=Ot(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function _u(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Zi:rm,u=Jn(c(t));s=Xr(l,u),l==10&&(s=Js[vi(s,Js)]);let h=t,f=s*l;l==10&&(f=Js[vi(f,Js)]);do a.push(h),h=h+s,l==10&&!bs.has(h)&&(h=Ot(h,bs.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Js[vi(f,Js)]));while(h<=i);return a}function Pv(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?_u(n,e,Un(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?_u(n,e,Un(l,-i),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var Am=/./,Lv=/[12357]/,Dv=/[125]/,Xp=/1/,xu=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Uv(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Am:l(7,o)-u>=c?Lv:l(5,o)-u>=c?Dv:Xp;if(h==Xp){let f=fn(l(1,o)-u);if(f<c)return xu(e.slice().reverse(),a.distr,h,ui(c/f)).reverse()}return xu(e,a.distr,h,1)}function Fv(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=fn(l(1,o)-l(2,o));return c<a?xu(e.slice().reverse(),3,Am,ui(a/c)).reverse():e}function Nv(n,e,t,i){return i==null?wu:e==null?"":Au(e)}var qp={show:!0,scale:"y",stroke:Mu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Em,side:3,grid:Pu,ticks:wm,border:Sm,font:Lu,lineGap:Tm,rotate:0};function kv(n,e){let t=3+(n||1)*2;return Ot(t*e,3)}function Ov(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=fn(o-r),l=n.series[e],c=a/(l.points.space*Tt);return i[1]-i[0]<=c}var $p={scale:null,auto:!0,sorted:0,min:kt,max:-kt},Cm=(n,e,t,i,s)=>s,Yp={show:!0,auto:!0,sorted:0,gaps:Cm,alpha:1,facets:[nn({},$p,{scale:"x"}),nn({},$p,{scale:"y"})]},Zp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Cm,alpha:1,points:{show:Ov,filter:null},values:null,min:kt,max:-kt,idxs:[],path:null,clip:null};function Bv(n,e,t,i,s){return t/10}var Rm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},zv=nn({},Rm,{time:!1,ori:1}),Jp={};function Im(n,e){let t=Jp[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Jp[n]=t)),t}var Yr=1,vu=2;function er(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,_=a.width,v=a.height,m=n.valToPosH,p=n.valToPosV;return u.ori==0?t(s,l,c,u,h,m,p,f,d,_,v,Pl,Jr,Dl,Lm,Um):t(s,l,c,u,h,p,m,d,f,v,_,Ll,Kr,Fu,Dm,Fm)}function Du(n,e){let t=0,i=0,s=Mt(n.bands,Cu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Vv(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ji(n,e,t,i,s,r){return er(n,e,(o,a,l,c,u,h,f,d,_,v,m)=>{let p=o.pxRound,T=c.dir*(c.ori==0?1:-1),S=c.ori==0?Jr:Kr,b,N;T==1?(b=t,N=i):(b=i,N=t);let L=p(h(a[b],c,v,d)),D=p(f(l[b],u,m,_)),B=p(h(a[N],c,v,d)),E=p(f(r==1?u.max:u.min,u,m,_)),M=new Path2D(s);return S(M,B,E),S(M,L,E),S(M,L,D),M})}function Il(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Dl:Fu,l=t;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Hv(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Uu(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let d=r(n[h]),_=f==h?d:r(n[f]),v=h-s;d=o<=0&&v>=0&&v<l?r(n[v]):d;let p=f+s;_=o>=0&&p>=0&&p<l?r(n[p]):_,_>=d&&a.push([d,_])}return a}function Kp(n){return n==0?am:n==1?un:e=>Zs(e,n)}function Pm(n){let e=n==0?Pl:Ll,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=yi(c,a/2,l/2),u=yi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Pl=(n,e,t)=>{n.moveTo(e,t)},Ll=(n,e,t)=>{n.moveTo(t,e)},Jr=(n,e,t)=>{n.lineTo(e,t)},Kr=(n,e,t)=>{n.lineTo(t,e)},Dl=Pm(0),Fu=Pm(1),Lm=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},Dm=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Um=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Fm=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Nm(n){return(e,t,i,s,r)=>er(e,t,(o,a,l,c,u,h,f,d,_,v,m)=>{let{pxRound:p,points:T}=o,S,b;c.ori==0?(S=Pl,b=Lm):(S=Ll,b=Dm);let N=Ot(T.width*Tt,3),L=(T.size-T.width)/2*Tt,D=Ot(L*2,3),B=new Path2D,E=new Path2D,{left:M,top:I,width:q,height:z}=e.bbox;Dl(E,M-D,I-D,q+D*2,z+D*2);let W=Y=>{if(l[Y]!=null){let $=p(h(a[Y],c,v,d)),j=p(f(l[Y],u,m,_));S(B,$+L,j),b(B,$,j,L,0,Ml*2)}};if(r)r.forEach(W);else for(let Y=i;Y<=s;Y++)W(Y);return{stroke:N>0?B:null,fill:B,clip:E,flags:Yr|vu}})}function km(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var Gv=km(Jr),Wv=km(Kr);function Om(n){let e=Mt(n?.alignGaps,0);return(t,i,s,r)=>er(t,i,(o,a,l,c,u,h,f,d,_,v,m)=>{[s,r]=Tl(l,s,r);let p=o.pxRound,T=z=>p(h(z,c,v,d)),S=z=>p(f(z,u,m,_)),b,N;c.ori==0?(b=Jr,N=Gv):(b=Kr,N=Wv);let L=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Yr},B=D.stroke,E=!1;if(r-s>=v*4){let z=me=>t.posToVal(me,c.key,!0),W=null,Y=null,$,j,Q,he=T(a[L==1?s:r]),ce=T(a[s]),_e=T(a[r]),Se=z(L==1?ce+1:_e-1);for(let me=L==1?s:r;me>=s&&me<=r;me+=L){let ee=a[me],ve=(L==1?ee<Se:ee>Se)?he:T(ee),ae=l[me];ve==he?ae!=null?(j=ae,W==null?(b(B,ve,S(j)),$=W=Y=j):j<W?W=j:j>Y&&(Y=j)):ae===null&&(E=!0):(W!=null&&N(B,he,S(W),S(Y),S($),S(j)),ae!=null?(j=ae,b(B,ve,S(j)),W=Y=$=j):(W=Y=null,ae===null&&(E=!0)),he=ve,Se=z(he+L))}W!=null&&W!=Y&&Q!=he&&N(B,he,S(W),S(Y),S($),S(j))}else for(let z=L==1?s:r;z>=s&&z<=r;z+=L){let W=l[z];W===null?E=!0:W!=null&&b(B,T(a[z]),S(W))}let[I,q]=Du(t,i);if(o.fill!=null||I!=0){let z=D.fill=new Path2D(B),W=o.fillTo(t,i,o.min,o.max,I),Y=S(W),$=T(a[s]),j=T(a[r]);L==-1&&([j,$]=[$,j]),b(z,j,Y),b(z,$,Y)}if(!o.spanGaps){let z=[];E&&z.push(...Uu(a,l,s,r,L,T,e)),D.gaps=z=o.gaps(t,i,s,r,z),D.clip=Il(z,c.ori,d,_,v,m)}return q!=0&&(D.band=q==2?[Ji(t,i,s,r,B,-1),Ji(t,i,s,r,B,1)]:Ji(t,i,s,r,B,q)),D})}function Xv(n){let e=Mt(n.align,1),t=Mt(n.ascDesc,!1),i=Mt(n.alignGaps,0),s=Mt(n.extend,!1);return(r,o,a,l)=>er(r,o,(c,u,h,f,d,_,v,m,p,T,S)=>{[a,l]=Tl(h,a,l);let b=c.pxRound,{left:N,width:L}=r.bbox,D=ce=>b(_(ce,f,T,m)),B=ce=>b(v(ce,d,S,p)),E=f.ori==0?Jr:Kr,M={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Yr},I=M.stroke,q=f.dir*(f.ori==0?1:-1),z=B(h[q==1?a:l]),W=D(u[q==1?a:l]),Y=W,$=W;s&&e==-1&&($=N,E(I,$,z)),E(I,W,z);for(let ce=q==1?a:l;ce>=a&&ce<=l;ce+=q){let _e=h[ce];if(_e==null)continue;let Se=D(u[ce]),me=B(_e);e==1?E(I,Se,z):E(I,Y,me),E(I,Se,me),z=me,Y=Se}let j=Y;s&&e==1&&(j=N+L,E(I,j,z));let[Q,he]=Du(r,o);if(c.fill!=null||Q!=0){let ce=M.fill=new Path2D(I),_e=c.fillTo(r,o,c.min,c.max,Q),Se=B(_e);E(ce,j,Se),E(ce,$,Se)}if(!c.spanGaps){let ce=[];ce.push(...Uu(u,h,a,l,q,D,i));let _e=c.width*Tt/2,Se=t||e==1?_e:-_e,me=t||e==-1?-_e:_e;ce.forEach(ee=>{ee[0]+=Se,ee[1]+=me}),M.gaps=ce=c.gaps(r,o,a,l,ce),M.clip=Il(ce,f.ori,m,p,T,S)}return he!=0&&(M.band=he==2?[Ji(r,o,a,l,I,-1),Ji(r,o,a,l,I,1)]:Ji(r,o,a,l,I,he)),M})}function jp(n,e,t,i,s,r,o=kt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=fn(n[l]-n[a]);u<c&&(c=u,o=fn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function qv(n){n=n||ra;let e=Mt(n.size,[.6,kt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=dt(s),o=1-e[0],a=Mt(e[1],kt),l=Mt(e[2],1),c=Mt(n.disp,ra),u=Mt(n.each,d=>{}),{fill:h,stroke:f}=c;return(d,_,v,m)=>er(d,_,(p,T,S,b,N,L,D,B,E,M,I)=>{let q=p.pxRound,z=t,W=i*Tt,Y=a*Tt,$=l*Tt,j,Q;b.ori==0?[j,Q]=r(d,_):[Q,j]=r(d,_);let he=b.dir*(b.ori==0?1:-1),ce=b.ori==0?Dl:Fu,_e=b.ori==0?u:(U,J,ne,te,Oe,ge,Ue)=>{u(U,J,ne,Oe,te,Ue,ge)},Se=Mt(d.bands,Cu).find(U=>U.series[0]==_),me=Se!=null?Se.dir:0,ee=p.fillTo(d,_,p.min,p.max,me),ue=q(D(ee,N,I,E)),ve,ae,Ne,tt=M,Ce=q(p.width*Tt),_t=!1,xt=null,st=null,F=null,Kt=null;h!=null&&(Ce==0||f!=null)&&(_t=!0,xt=h.values(d,_,v,m),st=new Map,new Set(xt).forEach(U=>{U!=null&&st.set(U,new Path2D)}),Ce>0&&(F=f.values(d,_,v,m),Kt=new Map,new Set(F).forEach(U=>{U!=null&&Kt.set(U,new Path2D)})));let{x0:ut,size:vt}=c;if(ut!=null&&vt!=null){z=1,T=ut.values(d,_,v,m),ut.unit==2&&(T=T.map(ne=>d.posToVal(B+ne*M,b.key,!0)));let U=vt.values(d,_,v,m);vt.unit==2?ae=U[0]*M:ae=L(U[0],b,M,B)-L(0,b,M,B),tt=jp(T,S,L,b,M,B,tt),Ne=tt-ae+W}else tt=jp(T,S,L,b,M,B,tt),Ne=tt*o+W,ae=tt-Ne;Ne<1&&(Ne=0),Ce>=ae/2&&(Ce=0),Ne<5&&(q=am);let ze=Ne>0,at=tt-Ne-(ze?Ce:0);ae=q(gu(at,$,Y)),ve=(z==0?ae/2:z==he?0:ae)-z*he*((z==0?W/2:0)+(ze?Ce/2:0));let De={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},et=_t?null:new Path2D,It=null;if(Se!=null)It=d.data[Se.series[1]];else{let{y0:U,y1:J}=c;U!=null&&J!=null&&(S=J.values(d,_,v,m),It=U.values(d,_,v,m))}let P=j*ae,x=Q*ae;for(let U=he==1?v:m;U>=v&&U<=m;U+=he){let J=S[U];if(J==null)continue;if(It!=null){let ye=It[U]??0;if(J-ye==0)continue;ue=D(ye,N,I,E)}let ne=b.distr!=2||c!=null?T[U]:U,te=L(ne,b,M,B),Oe=D(Mt(J,ee),N,I,E),ge=q(te-ve),Ue=q(Un(Oe,ue)),Re=q(yi(Oe,ue)),se=Ue-Re;if(J!=null){let ye=J<0?x:P,Ge=J<0?P:x;_t?(Ce>0&&F[U]!=null&&ce(Kt.get(F[U]),ge,Re+Jn(Ce/2),ae,Un(0,se-Ce),ye,Ge),xt[U]!=null&&ce(st.get(xt[U]),ge,Re+Jn(Ce/2),ae,Un(0,se-Ce),ye,Ge)):ce(et,ge,Re+Jn(Ce/2),ae,Un(0,se-Ce),ye,Ge),_e(d,_,U,ge-Ce/2,Re,ae+Ce,se)}}return Ce>0?De.stroke=_t?Kt:et:_t||(De._fill=p.width==0?p._fill:p._stroke??p._fill,De.width=0),De.fill=_t?st:et,De})}function $v(n,e){let t=Mt(e?.alignGaps,0);return(i,s,r,o)=>er(i,s,(a,l,c,u,h,f,d,_,v,m,p)=>{[r,o]=Tl(c,r,o);let T=a.pxRound,S=j=>T(f(j,u,m,_)),b=j=>T(d(j,h,p,v)),N,L,D;u.ori==0?(N=Pl,D=Jr,L=Um):(N=Ll,D=Kr,L=Fm);let B=u.dir*(u.ori==0?1:-1),E=S(l[B==1?r:o]),M=E,I=[],q=[];for(let j=B==1?r:o;j>=r&&j<=o;j+=B)if(c[j]!=null){let he=l[j],ce=S(he);I.push(M=ce),q.push(b(c[j]))}let z={stroke:n(I,q,N,D,L,T),fill:null,clip:null,band:null,gaps:null,flags:Yr},W=z.stroke,[Y,$]=Du(i,s);if(a.fill!=null||Y!=0){let j=z.fill=new Path2D(W),Q=a.fillTo(i,s,a.min,a.max,Y),he=b(Q);D(j,M,he),D(j,E,he)}if(!a.spanGaps){let j=[];j.push(...Uu(l,c,r,o,B,S,t)),z.gaps=j=a.gaps(i,s,r,o,j),z.clip=Il(j,u.ori,_,v,m,p)}return $!=0&&(z.band=$==2?[Ji(i,s,r,o,W,-1),Ji(i,s,r,o,W,1)]:Ji(i,s,r,o,W,$)),z})}function Yv(n){return $v(Zv,n)}function Zv(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,e[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,n[f+1],e[f+1])}return a}var yu=new Set;function Qp(){for(let n of yu)n.syncRect(!0)}Zr&&(js(Rx,Wr,Qp),js(Ix,Wr,Qp,!0),js(wl,Wr,()=>{wn.pxRatio=Tt}));var Jv=Om(),Kv=Nm();function em(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>bu(r,o,e,t))}function jv(n,e){return n.map((t,i)=>i==0?{}:nn({},e,t))}function bu(n,e,t,i){return nn({},e==0?t:i,n)}function Bm(n,e,t){return e==null?qr:[e,t]}var Qv=Bm;function ey(n,e,t){return e==null?qr:Sl(e,t,Tu,!0)}function zm(n,e,t,i){return e==null?qr:Al(e,t,n.scales[i].log,!1)}var ty=zm;function Vm(n,e,t,i){return e==null?qr:Eu(e,t,n.scales[i].log,!1)}var ny=Vm;function iy(n,e,t,i,s){let r=Un(Lp(n),Lp(e)),o=e-n,a=vi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?bs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function tm(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=un((t=+s)*Tt))+"px"),[n,e,t]}function sy(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Ot(e[2]*Tt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function wn(n,e,t){let i={mode:Mt(n.mode,1)},s=i.mode;function r(g,y,A,R){let O=y.valToPct(g);return R+A*(y.dir==-1?1-O:O)}function o(g,y,A,R){let O=y.valToPct(g);return R+A*(y.dir==-1?O:1-O)}function a(g,y,A,R){return y.ori==0?r(g,y,A,R):o(g,y,A,R)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=hi(ux);if(n.id!=null&&(c.id=n.id),Zn(c,n.class),n.title){let g=hi(px,c);g.textContent=n.title}let u=xi("canvas"),h=i.ctx=u.getContext("2d"),f=hi(mx,c);js("click",f,g=>{g.target===_&&(Vt!=kr||$t!=Or)&&Mn.click(i,g)},!0);let d=i.under=hi(gx,f);f.appendChild(u);let _=i.over=hi(_x,f);n=$r(n);let v=+Mt(n.pxAlign,1),m=Kp(v);(n.plugins||[]).forEach(g=>{g.opts&&(n=g.opts(i,n)||n)});let p=n.ms||.001,T=i.series=s==1?em(n.series||[],Wp,Zp,!1):jv(n.series||[null],Yp),S=i.axes=em(n.axes||[],Gp,qp,!0),b=i.scales={},N=i.bands=n.bands||[];N.forEach(g=>{g.fill=dt(g.fill||null),g.dir=Mt(g.dir,-1)});let L=s==2?T[1].facets[0].scale:T[0].scale,D={axes:J_,series:Rn},B=(n.drawOrder||["axes","series"]).map(g=>D[g]);function E(g){let y=g.distr==3?A=>Zi(A>0?A:g.clamp(i,A,g.min,g.max,g.key)):g.distr==4?A=>lu(A,g.asinh):g.distr==100?A=>g.fwd(A):A=>A;return A=>{let R=y(A),{_min:O,_max:G}=g,ie=G-O;return(R-O)/ie}}function M(g){let y=b[g];if(y==null){let A=(n.scales||ra)[g]||ra;if(A.from!=null){M(A.from);let R=nn({},b[A.from],A,{key:g});R.valToPct=E(R),b[g]=R}else{y=b[g]=nn({},g==L?Rm:zv,A),y.key=g;let R=y.time,O=y.range,G=ys(O);if((g!=L||s==2&&!R)&&(G&&(O[0]==null||O[1]==null)&&(O={min:O[0]==null?Rp:{mode:1,hard:O[0],soft:O[0]},max:O[1]==null?Rp:{mode:1,hard:O[1],soft:O[1]}},G=!1),!G&&Rl(O))){let ie=O;O=(le,pe,Ae)=>pe==null?qr:Sl(pe,Ae,ie)}y.range=dt(O||(R?Qv:g==L?y.distr==3?ty:y.distr==4?ny:Bm:y.distr==3?zm:y.distr==4?Vm:ey)),y.auto=dt(G?!1:y.auto),y.clamp=dt(y.clamp||Bv),y._min=y._max=null,y.valToPct=E(y)}}}M("x"),M("y"),s==1&&T.forEach(g=>{M(g.scale)}),S.forEach(g=>{M(g.scale)});for(let g in n.scales)M(g);let I=b[L],q=I.distr,z,W;I.ori==0?(Zn(c,fx),z=r,W=o):(Zn(c,dx),z=o,W=r);let Y={};for(let g in b){let y=b[g];(y.min!=null||y.max!=null)&&(Y[g]={min:y.min,max:y.max},y.min=y.max=null)}let $=n.tzDate||(g=>new Date(un(g/p))),j=n.fmtDate||Ru,Q=p==1?fv($):mv($),he=zp($,Bp(p==1?uv:pv,j)),ce=Hp($,Vp(_v,j)),_e=[],Se=i.legend=nn({},yv,n.legend),me=i.cursor=nn({},Tv,{drag:{y:s==2}},n.cursor),ee=Se.show,ue=me.show,ve=Se.markers;Se.idxs=_e,ve.width=dt(ve.width),ve.dash=dt(ve.dash),ve.stroke=dt(ve.stroke),ve.fill=dt(ve.fill);let ae,Ne,tt,Ce=[],_t=[],xt,st=!1,F={};if(Se.live){let g=T[1]?T[1].values:null;st=g!=null,xt=st?g(i,1,0):{_:0};for(let y in xt)F[y]=wu}if(ee)if(ae=xi("table",wx,c),tt=xi("tbody",null,ae),Se.mount(i,ae),st){Ne=xi("thead",null,ae,tt);let g=xi("tr",null,Ne);xi("th",null,g);for(var Kt in xt)xi("th",gp,g).textContent=Kt}else Zn(ae,Ex),Se.live&&Zn(ae,Sx);let ut={show:!0},vt={show:!1};function ze(g,y){if(y==0&&(st||!Se.live||s==2))return qr;let A=[],R=xi("tr",Tx,tt,tt.childNodes[y]);Zn(R,g.class),g.show||Zn(R,Ks);let O=xi("th",null,R);if(ve.show){let le=hi(Ax,O);if(y>0){let pe=ve.width(i,y);pe&&(le.style.border=pe+"px "+ve.dash(i,y)+" "+ve.stroke(i,y)),le.style.background=ve.fill(i,y)}}let G=hi(gp,O);g.label instanceof HTMLElement?G.appendChild(g.label):G.textContent=g.label,y>0&&(ve.show||(G.style.color=g.width>0?ve.stroke(i,y):ve.fill(i,y)),De("click",O,le=>{if(me._lock)return;an(le);let pe=T.indexOf(g);if((le.ctrlKey||le.metaKey)!=Se.isolate){let Ae=T.some((Ie,ke)=>ke>0&&ke!=pe&&Ie.show);T.forEach((Ie,ke)=>{ke>0&&Ti(ke,Ae?ke==pe?ut:vt:ut,!0,tn.setSeries)})}else Ti(pe,{show:!g.show},!0,tn.setSeries)},!1),Wi&&De(yp,O,le=>{me._lock||(an(le),Ti(T.indexOf(g),zr,!0,tn.setSeries))},!1));for(var ie in xt){let le=xi("td",Cx,R);le.textContent="--",A.push(le)}return[R,A]}let at=new Map;function De(g,y,A,R=!0){let O=at.get(y)||{},G=me.bind[g](i,y,A,R);G&&(js(g,y,O[g]=G),at.set(y,O))}function et(g,y,A){let R=at.get(y)||{};for(let O in R)(g==null||O==g)&&(mu(O,y,R[O]),delete R[O]);g==null&&at.delete(y)}let It=0,P=0,x=0,U=0,J=0,ne=0,te=J,Oe=ne,ge=x,Ue=U,Re=0,se=0,ye=0,Ge=0;i.bbox={};let qe=!1,be=!1,Ye=!1,k=!1,Me=!1,oe=!1;function Fe(g,y,A){(A||g!=i.width||y!=i.height)&&fe(g,y),Dr(!1),Ye=!0,be=!0,Ur()}function fe(g,y){i.width=It=x=g,i.height=P=U=y,J=ne=0,Ut(),St();let A=i.bbox;Re=A.left=Zs(J*Tt,.5),se=A.top=Zs(ne*Tt,.5),ye=A.width=Zs(x*Tt,.5),Ge=A.height=Zs(U*Tt,.5)}let re=3;function Be(){let g=!1,y=0;for(;!g;){y++;let A=Y_(y),R=Z_(y);g=y==re||A&&R,g||(fe(i.width,i.height),be=!0)}}function nt({width:g,height:y}){Fe(g,y)}i.setSize=nt;function Ut(){let g=!1,y=!1,A=!1,R=!1;S.forEach((O,G)=>{if(O.show&&O._show){let{side:ie,_size:le}=O,pe=ie%2,Ae=O.label!=null?O.labelSize:0,Ie=le+Ae;Ie>0&&(pe?(x-=Ie,ie==3?(J+=Ie,R=!0):A=!0):(U-=Ie,ie==0?(ne+=Ie,g=!0):y=!0))}}),Si[0]=g,Si[1]=A,Si[2]=y,Si[3]=R,x-=Ei[1]+Ei[3],J+=Ei[3],U-=Ei[2]+Ei[0],ne+=Ei[0]}function St(){let g=J+x,y=ne+U,A=J,R=ne;function O(G,ie){switch(G){case 1:return g+=ie,g-ie;case 2:return y+=ie,y-ie;case 3:return A-=ie,A+ie;case 0:return R-=ie,R+ie}}S.forEach((G,ie)=>{if(G.show&&G._show){let le=G.side;G._pos=O(le,G._size),G.label!=null&&(G._lpos=O(le,G.labelSize))}})}if(me.dataIdx==null){let g=me.hover,y=g.skip=new Set(g.skip??[]);y.add(void 0);let A=g.prox=dt(g.prox),R=g.bias??(g.bias=0);me.dataIdx=(O,G,ie,le)=>{if(G==0)return ie;let pe=ie,Ae=A(O,G,ie,le)??kt,Ie=Ae>=0&&Ae<kt,ke=I.ori==0?x:U,it=me.left,Et=e[0],bt=e[G];if(y.has(bt[ie])){pe=null;let ft=null,Ke=null,Xe;if(R==0||R==-1)for(Xe=ie;ft==null&&Xe-- >0;)y.has(bt[Xe])||(ft=Xe);if(R==0||R==1)for(Xe=ie;Ke==null&&Xe++<bt.length;)y.has(bt[Xe])||(Ke=Xe);if(ft!=null||Ke!=null)if(Ie){let Gt=ft==null?-1/0:z(Et[ft],I,ke,0),jt=Ke==null?1/0:z(Et[Ke],I,ke,0),yn=it-Gt,Dt=jt-it;yn<=Dt?yn<=Ae&&(pe=ft):Dt<=Ae&&(pe=Ke)}else pe=Ke==null?ft:ft==null?Ke:ie-ft<=Ke-ie?ft:Ke}else Ie&&fn(it-z(Et[ie],I,ke,0))>Ae&&(pe=null);return pe}}let an=g=>{me.event=g};me.idxs=_e,me._lock=!1;let Bt=me.points;Bt.show=dt(Bt.show),Bt.size=dt(Bt.size),Bt.stroke=dt(Bt.stroke),Bt.width=dt(Bt.width),Bt.fill=dt(Bt.fill);let Xn=i.focus=nn({},n.focus||{alpha:.3},me.focus),Wi=Xn.prox>=0,On=Wi&&Bt.one,Sn=[],Xi=[],qi=[];function Ws(g,y){let A=Bt.show(i,y);if(A instanceof HTMLElement)return Zn(A,Mx),Zn(A,g.class),Ii(A,-10,-10,x,U),_.insertBefore(A,Sn[y]),A}function Yo(g,y){if(s==1||y>0){let A=s==1&&b[g.scale].time,R=g.value;g.value=A?Fp(R)?Hp($,Vp(R,j)):R||ce:R||Nv,g.label=g.label||(A?Cv:Av)}if(On||y>0){g.width=g.width==null?1:g.width,g.paths=g.paths||Jv||zx,g.fillTo=dt(g.fillTo||Vv),g.pxAlign=+Mt(g.pxAlign,v),g.pxRound=Kp(g.pxAlign),g.stroke=dt(g.stroke||null),g.fill=dt(g.fill||null),g._stroke=g._fill=g._paths=g._focus=null;let A=kv(Un(1,g.width),1),R=g.points=nn({},{size:A,width:Un(1,A*.2),stroke:g.stroke,space:A*2,paths:Kv,_stroke:null,_fill:null},g.points);R.show=dt(R.show),R.filter=dt(R.filter),R.fill=dt(R.fill),R.stroke=dt(R.stroke),R.paths=dt(R.paths),R.pxAlign=g.pxAlign}if(ee){let A=ze(g,y);Ce.splice(y,0,A[0]),_t.splice(y,0,A[1]),Se.values.push(null)}if(ue){_e.splice(y,0,null);let A=null;On?y==0&&(A=Ws(g,y)):y>0&&(A=Ws(g,y)),Sn.splice(y,0,A),Xi.splice(y,0,0),qi.splice(y,0,0)}vn("addSeries",y)}function Lr(g,y){y=y??T.length,g=s==1?bu(g,y,Wp,Zp):bu(g,y,{},Yp),T.splice(y,0,g),Yo(T[y],y)}i.addSeries=Lr;function pl(g){if(T.splice(g,1),ee){Se.values.splice(g,1),_t.splice(g,1);let y=Ce.splice(g,1)[0];et(null,y.firstChild),y.remove()}ue&&(_e.splice(g,1),Sn.splice(g,1)[0].remove(),Xi.splice(g,1),qi.splice(g,1)),vn("delSeries",g)}i.delSeries=pl;let Si=[!1,!1,!1,!1];function $h(g,y){if(g._show=g.show,g.show){let A=g.side%2,R=b[g.scale];R==null&&(g.scale=A?T[1].scale:L,R=b[g.scale]);let O=R.time;g.size=dt(g.size),g.space=dt(g.space),g.rotate=dt(g.rotate),ys(g.incrs)&&g.incrs.forEach(ie=>{!bs.has(ie)&&bs.set(ie,hm(ie))}),g.incrs=dt(g.incrs||(R.distr==2?lv:O?p==1?hv:dv:Js)),g.splits=dt(g.splits||(O&&R.distr==1?Q:R.distr==3?_u:R.distr==4?Pv:Iv)),g.stroke=dt(g.stroke),g.grid.stroke=dt(g.grid.stroke),g.ticks.stroke=dt(g.ticks.stroke),g.border.stroke=dt(g.border.stroke);let G=g.values;g.values=ys(G)&&!ys(G[0])?dt(G):O?ys(G)?zp($,Bp(G,j)):Fp(G)?gv($,G):G||he:G||Rv,g.filter=dt(g.filter||(R.distr>=3&&R.log==10?Uv:R.distr==3&&R.log==2?Fv:lm)),g.font=tm(g.font),g.labelFont=tm(g.labelFont),g._size=g.size(i,null,y,0),g._space=g._rotate=g._incrs=g._found=g._splits=g._values=null,g._size>0&&(Si[y]=!0,g._el=hi(xx,f))}}function Xs(g,y,A,R){let[O,G,ie,le]=A,pe=y%2,Ae=0;return pe==0&&(le||G)&&(Ae=y==0&&!O||y==2&&!ie?un(Gp.size/3):0),pe==1&&(O||ie)&&(Ae=y==1&&!G||y==3&&!le?un(qp.size/2):0),Ae}let ml=i.padding=(n.padding||[Xs,Xs,Xs,Xs]).map(g=>dt(Mt(g,Xs))),Ei=i._padding=ml.map((g,y)=>g(i,y,Si,0)),ln,en=null,w=null,V=s==1?T[0].idxs:null,X=null,Z=!1;function H(g,y){if(e=g??[],i.data=i._data=e,s==2){ln=0;for(let A=1;A<T.length;A++)ln+=e[A][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),X=e[0],ln=X.length;let A=e;if(q==2){A=e.slice();let R=A[0]=Array(ln);for(let O=0;O<ln;O++)R[O]=O}i._data=e=A}if(Dr(!0),vn("setData"),q==2&&(Ye=!0),y!==!1){let A=I;A.auto(i,Z)?de():_s(L,A.min,A.max),k=k||me.left>=0,oe=!0,Ur()}}i.setData=H;function de(){Z=!0;let g,y;s==1&&(ln>0?(en=V[0]=0,w=V[1]=ln-1,g=e[0][en],y=e[0][w],q==2?(g=en,y=w):g==y&&(q==3?[g,y]=Al(g,g,I.log,!1):q==4?[g,y]=Eu(g,g,I.log,!1):I.time?y=g+un(86400/p):[g,y]=Sl(g,y,Tu,!0))):(en=V[0]=g=null,w=V[1]=y=null)),_s(L,g,y)}let we,Le,Pe,Ze,Je,We,lt,yt,zt,ct;function Ct(g,y,A,R,O,G){g??(g=xp),A??(A=Cu),R??(R="butt"),O??(O=xp),G??(G="round"),g!=we&&(h.strokeStyle=we=g),O!=Le&&(h.fillStyle=Le=O),y!=Pe&&(h.lineWidth=Pe=y),G!=Je&&(h.lineJoin=Je=G),R!=We&&(h.lineCap=We=R),A!=Ze&&h.setLineDash(Ze=A)}function $e(g,y,A,R){y!=Le&&(h.fillStyle=Le=y),g!=lt&&(h.font=lt=g),A!=yt&&(h.textAlign=yt=A),R!=zt&&(h.textBaseline=zt=R)}function Ft(g,y,A,R,O=0){if(R.length>0&&g.auto(i,Z)&&(y==null||y.min==null)){let G=Mt(en,0),ie=Mt(w,R.length-1),le=A.min==null?Ux(R,G,ie,O,g.distr==3):[A.min,A.max];g.min=yi(g.min,A.min=le[0]),g.max=Un(g.max,A.max=le[1])}}let pt={min:null,max:null};function Cn(){for(let R in b){let O=b[R];Y[R]==null&&(O.min==null||Y[L]!=null&&O.auto(i,Z))&&(Y[R]=pt)}for(let R in b){let O=b[R];Y[R]==null&&O.from!=null&&Y[O.from]!=null&&(Y[R]=pt)}Y[L]!=null&&Dr(!0);let g={};for(let R in Y){let O=Y[R];if(O!=null){let G=g[R]=$r(b[R],Gx);if(O.min!=null)nn(G,O);else if(R!=L||s==2)if(ln==0&&G.from==null){let ie=G.range(i,null,null,R);G.min=ie[0],G.max=ie[1]}else G.min=kt,G.max=-kt}}if(ln>0){T.forEach((R,O)=>{if(s==1){let G=R.scale,ie=Y[G];if(ie==null)return;let le=g[G];if(O==0){let pe=le.range(i,le.min,le.max,G);le.min=pe[0],le.max=pe[1],en=vi(le.min,e[0]),w=vi(le.max,e[0]),w-en>1&&(e[0][en]<le.min&&en++,e[0][w]>le.max&&w--),R.min=X[en],R.max=X[w]}else R.show&&R.auto&&Ft(le,ie,R,e[O],R.sorted);R.idxs[0]=en,R.idxs[1]=w}else if(O>0&&R.show&&R.auto){let[G,ie]=R.facets,le=G.scale,pe=ie.scale,[Ae,Ie]=e[O],ke=g[le],it=g[pe];ke!=null&&Ft(ke,Y[le],G,Ae,G.sorted),it!=null&&Ft(it,Y[pe],ie,Ie,ie.sorted),R.min=ie.min,R.max=ie.max}});for(let R in g){let O=g[R],G=Y[R];if(O.from==null&&(G==null||G.min==null)){let ie=O.range(i,O.min==kt?null:O.min,O.max==-kt?null:O.max,R);O.min=ie[0],O.max=ie[1]}}}for(let R in g){let O=g[R];if(O.from!=null){let G=g[O.from];if(G.min==null)O.min=O.max=null;else{let ie=O.range(i,G.min,G.max,R);O.min=ie[0],O.max=ie[1]}}}let y={},A=!1;for(let R in g){let O=g[R],G=b[R];if(G.min!=O.min||G.max!=O.max){G.min=O.min,G.max=O.max;let ie=G.distr;G._min=ie==3?Zi(G.min):ie==4?lu(G.min,G.asinh):ie==100?G.fwd(G.min):G.min,G._max=ie==3?Zi(G.max):ie==4?lu(G.max,G.asinh):ie==100?G.fwd(G.max):G.max,y[R]=A=!0}}if(A){T.forEach((R,O)=>{s==2?O>0&&y.y&&(R._paths=null):y[R.scale]&&(R._paths=null)});for(let R in y)Ye=!0,vn("setScale",R);ue&&me.left>=0&&(k=oe=!0)}for(let R in Y)Y[R]=null}function ds(g){let y=gu(en-1,0,ln-1),A=gu(w+1,0,ln-1);for(;g[y]==null&&y>0;)y--;for(;g[A]==null&&A<ln-1;)A++;return[y,A]}function Rn(){if(ln>0){let g=T.some(y=>y._focus)&&ct!=Xn.alpha;g&&(h.globalAlpha=ct=Xn.alpha),T.forEach((y,A)=>{if(A>0&&y.show&&(ps(A,!1),ps(A,!0),y._paths==null)){let R=ct;ct!=y.alpha&&(h.globalAlpha=ct=y.alpha);let O=s==2?[0,e[A][0].length-1]:ds(e[A]);y._paths=y.paths(i,A,O[0],O[1]),ct!=R&&(h.globalAlpha=ct=R)}}),T.forEach((y,A)=>{if(A>0&&y.show){let R=ct;ct!=y.alpha&&(h.globalAlpha=ct=y.alpha),y._paths!=null&&Nt(A,!1);{let O=y._paths!=null?y._paths.gaps:null,G=y.points.show(i,A,en,w,O),ie=y.points.filter(i,A,G,O);(G||ie)&&(y.points._paths=y.points.paths(i,A,en,w,ie),Nt(A,!0))}ct!=R&&(h.globalAlpha=ct=R),vn("drawSeries",A)}}),g&&(h.globalAlpha=ct=1)}}function ps(g,y){let A=y?T[g].points:T[g];A._stroke=A.stroke(i,g),A._fill=A.fill(i,g)}function Nt(g,y){let A=y?T[g].points:T[g],{stroke:R,fill:O,clip:G,flags:ie,_stroke:le=A._stroke,_fill:pe=A._fill,_width:Ae=A.width}=A._paths;Ae=Ot(Ae*Tt,3);let Ie=null,ke=Ae%2/2;y&&pe==null&&(pe=Ae>0?"#fff":le);let it=A.pxAlign==1&&ke>0;if(it&&h.translate(ke,ke),!y){let Et=Re-Ae/2,bt=se-Ae/2,ft=ye+Ae,Ke=Ge+Ae;Ie=new Path2D,Ie.rect(Et,bt,ft,Ke)}y?cn(le,Ae,A.dash,A.cap,pe,R,O,ie,G):Bn(g,le,Ae,A.dash,A.cap,pe,R,O,ie,Ie,G),it&&h.translate(-ke,-ke)}function Bn(g,y,A,R,O,G,ie,le,pe,Ae,Ie){let ke=!1;pe!=0&&N.forEach((it,Et)=>{if(it.series[0]==g){let bt=T[it.series[1]],ft=e[it.series[1]],Ke=(bt._paths||ra).band;ys(Ke)&&(Ke=it.dir==1?Ke[0]:Ke[1]);let Xe,Gt=null;bt.show&&Ke&&Nx(ft,en,w)?(Gt=it.fill(i,Et)||G,Xe=bt._paths.clip):Ke=null,cn(y,A,R,O,Gt,ie,le,pe,Ae,Ie,Xe,Ke),ke=!0}}),ke||cn(y,A,R,O,G,ie,le,pe,Ae,Ie)}let In=Yr|vu;function cn(g,y,A,R,O,G,ie,le,pe,Ae,Ie,ke){Ct(g,y,A,R,O),(pe||Ae||ke)&&(h.save(),pe&&h.clip(pe),Ae&&h.clip(Ae)),ke?(le&In)==In?(h.clip(ke),Ie&&h.clip(Ie),ms(O,ie),hn(g,G,y)):le&vu?(ms(O,ie),h.clip(ke),hn(g,G,y)):le&Yr&&(h.save(),h.clip(ke),Ie&&h.clip(Ie),ms(O,ie),h.restore(),hn(g,G,y)):(ms(O,ie),hn(g,G,y)),(pe||Ae||ke)&&h.restore()}function hn(g,y,A){A>0&&(y instanceof Map?y.forEach((R,O)=>{h.strokeStyle=we=O,h.stroke(R)}):y!=null&&g&&h.stroke(y))}function ms(g,y){y instanceof Map?y.forEach((A,R)=>{h.fillStyle=Le=R,h.fill(A)}):y!=null&&g&&h.fill(y)}function $i(g,y,A,R){let O=S[g],G;if(R<=0)G=[0,0];else{let ie=O._space=O.space(i,g,y,A,R),le=O._incrs=O.incrs(i,g,y,A,R,ie);G=iy(y,A,le,R,ie)}return O._found=G}function Yh(g,y,A,R,O,G,ie,le,pe,Ae){let Ie=ie%2/2;v==1&&h.translate(Ie,Ie),Ct(le,ie,pe,Ae,le),h.beginPath();let ke,it,Et,bt,ft=O+(R==0||R==3?-G:G);A==0?(it=O,bt=ft):(ke=O,Et=ft);for(let Ke=0;Ke<g.length;Ke++)y[Ke]!=null&&(A==0?ke=Et=g[Ke]:it=bt=g[Ke],h.moveTo(ke,it),h.lineTo(Et,bt));h.stroke(),v==1&&h.translate(-Ie,-Ie)}function Y_(g){let y=!0;return S.forEach((A,R)=>{if(!A.show)return;let O=b[A.scale];if(O.min==null){A._show&&(y=!1,A._show=!1,Dr(!1));return}else A._show||(y=!1,A._show=!0,Dr(!1));let G=A.side,ie=G%2,{min:le,max:pe}=O,[Ae,Ie]=$i(R,le,pe,ie==0?x:U);if(Ie==0)return;let ke=O.distr==2,it=A._splits=A.splits(i,R,le,pe,Ae,Ie,ke),Et=O.distr==2?it.map(Xe=>X[Xe]):it,bt=O.distr==2?X[it[1]]-X[it[0]]:Ae,ft=A._values=A.values(i,A.filter(i,Et,R,Ie,bt),R,Ie,bt);A._rotate=G==2?A.rotate(i,ft,R,Ie):0;let Ke=A._size;A._size=ui(A.size(i,ft,R,g)),Ke!=null&&A._size!=Ke&&(y=!1)}),y}function Z_(g){let y=!0;return ml.forEach((A,R)=>{let O=A(i,R,Si,g);O!=Ei[R]&&(y=!1),Ei[R]=O}),y}function J_(){for(let g=0;g<S.length;g++){let y=S[g];if(!y.show||!y._show)continue;let A=y.side,R=A%2,O,G,ie=y.stroke(i,g),le=A==0||A==3?-1:1,[pe,Ae]=y._found;if(y.label!=null){let Ln=y.labelGap*le,Yn=un((y._lpos+Ln)*Tt);$e(y.labelFont[0],ie,"center",A==2?"top":_p),h.save(),R==1?(O=G=0,h.translate(Yn,un(se+Ge/2)),h.rotate((A==3?-Ml:Ml)/2)):(O=un(Re+ye/2),G=Yn);let Ys=om(y.label)?y.label(i,g,pe,Ae):y.label;h.fillText(Ys,O,G),h.restore()}if(Ae==0)continue;let Ie=b[y.scale],ke=R==0?ye:Ge,it=R==0?Re:se,Et=y._splits,bt=Ie.distr==2?Et.map(Ln=>X[Ln]):Et,ft=Ie.distr==2?X[Et[1]]-X[Et[0]]:pe,Ke=y.ticks,Xe=y.border,Gt=Ke.show?Ke.size:0,jt=un(Gt*Tt),yn=un((y.alignTo==2?y._size-Gt-y.gap:y.gap)*Tt),Dt=y._rotate*-Ml/180,Qt=m(y._pos*Tt),qn=(jt+yn)*le,Pn=Qt+qn;G=R==0?Pn:0,O=R==1?Pn:0;let li=y.font[0],gi=y.align==1?Hr:y.align==2?ru:Dt>0?Hr:Dt<0?ru:R==0?"center":A==3?ru:Hr,Ci=Dt||R==1?"middle":A==2?"top":_p;$e(li,ie,gi,Ci);let $n=y.font[1]*y.lineGap,ci=Et.map(Ln=>m(a(Ln,Ie,ke,it))),_i=y._values;for(let Ln=0;Ln<_i.length;Ln++){let Yn=_i[Ln];if(Yn!=null){R==0?O=ci[Ln]:G=ci[Ln],Yn=""+Yn;let Ys=Yn.indexOf(`
`)==-1?[Yn]:Yn.split(/\n/gm);for(let Dn=0;Dn<Ys.length;Dn++){let mp=Ys[Dn];Dt?(h.save(),h.translate(O,G+Dn*$n),h.rotate(Dt),h.fillText(mp,0,0),h.restore()):h.fillText(mp,O,G+Dn*$n)}}}Ke.show&&Yh(ci,Ke.filter(i,bt,g,Ae,ft),R,A,Qt,jt,Ot(Ke.width*Tt,3),Ke.stroke(i,g),Ke.dash,Ke.cap);let Ri=y.grid;Ri.show&&Yh(ci,Ri.filter(i,bt,g,Ae,ft),R,R==0?2:1,R==0?se:Re,R==0?Ge:ye,Ot(Ri.width*Tt,3),Ri.stroke(i,g),Ri.dash,Ri.cap),Xe.show&&Yh([Qt],[1],R==0?1:0,R==0?1:2,R==1?se:Re,R==1?Ge:ye,Ot(Xe.width*Tt,3),Xe.stroke(i,g),Xe.dash,Xe.cap)}vn("drawAxes")}function Dr(g){T.forEach((y,A)=>{A>0&&(y._paths=null,g&&(s==1?(y.min=null,y.max=null):y.facets.forEach(R=>{R.min=null,R.max=null})))})}let gl=!1,Zh=!1,Zo=[];function K_(){Zh=!1;for(let g=0;g<Zo.length;g++)vn(...Zo[g]);Zo.length=0}function Ur(){gl||(Jx(Kd),gl=!0)}function j_(g,y=!1){gl=!0,Zh=y,g(i),Kd(),y&&Zo.length>0&&queueMicrotask(K_)}i.batch=j_;function Kd(){if(qe&&(Cn(),qe=!1),Ye&&(Be(),Ye=!1),be){if(Wt(d,Hr,J),Wt(d,"top",ne),Wt(d,ta,x),Wt(d,na,U),Wt(_,Hr,J),Wt(_,"top",ne),Wt(_,ta,x),Wt(_,na,U),Wt(f,ta,It),Wt(f,na,P),u.width=un(It*Tt),u.height=un(P*Tt),S.forEach(({_el:g,_show:y,_size:A,_pos:R,side:O})=>{if(g!=null)if(y){let G=O===3||O===0?A:0,ie=O%2==1;Wt(g,ie?"left":"top",R-G),Wt(g,ie?"width":"height",A),Wt(g,ie?"top":"left",ie?ne:J),Wt(g,ie?"height":"width",ie?U:x),pu(g,Ks)}else Zn(g,Ks)}),we=Le=Pe=Je=We=lt=yt=zt=Ze=null,ct=1,jo(!0),J!=te||ne!=Oe||x!=ge||U!=Ue){Dr(!1);let g=x/ge,y=U/Ue;if(ue&&!k&&me.left>=0){me.left*=g,me.top*=y,Fr&&Ii(Fr,un(me.left),0,x,U),Nr&&Ii(Nr,0,un(me.top),x,U);for(let A=0;A<Sn.length;A++){let R=Sn[A];R!=null&&(Xi[A]*=g,qi[A]*=y,Ii(R,ui(Xi[A]),ui(qi[A]),x,U))}}if(Ht.show&&!Me&&Ht.left>=0&&Ht.width>0){Ht.left*=g,Ht.width*=g,Ht.top*=y,Ht.height*=y;for(let A in tu)Wt(Br,A,Ht[A])}te=J,Oe=ne,ge=x,Ue=U}vn("setSize"),be=!1}It>0&&P>0&&(h.clearRect(0,0,u.width,u.height),vn("drawClear"),B.forEach(g=>g()),vn("draw")),Ht.show&&Me&&(_l(Ht),Me=!1),ue&&k&&($s(null,!0,!1),k=!1),Se.show&&Se.live&&oe&&(Qh(),oe=!1),l||(l=!0,i.status=1,vn("ready")),Z=!1,gl=!1}i.redraw=(g,y)=>{Ye=y||!1,g!==!1?_s(L,I.min,I.max):Ur()};function Jh(g,y){let A=b[g];if(A.from==null){if(ln==0){let R=A.range(i,y.min,y.max,g);y.min=R[0],y.max=R[1]}if(y.min>y.max){let R=y.min;y.min=y.max,y.max=R}if(ln>1&&y.min!=null&&y.max!=null&&y.max-y.min<1e-16)return;g==L&&A.distr==2&&ln>0&&(y.min=vi(y.min,e[0]),y.max=vi(y.max,e[0]),y.min==y.max&&y.max++),Y[g]=y,qe=!0,Ur()}}i.setScale=Jh;let Kh,jh,Fr,Nr,jd,Qd,kr,Or,ep,tp,Vt,$t,gs=!1,Mn=me.drag,_n=Mn.x,xn=Mn.y;ue&&(me.x&&(Kh=hi(yx,_)),me.y&&(jh=hi(bx,_)),I.ori==0?(Fr=Kh,Nr=jh):(Fr=jh,Nr=Kh),Vt=me.left,$t=me.top);let Ht=i.select=nn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Br=Ht.show?hi(vx,Ht.over?_:d):null;function _l(g,y){if(Ht.show){for(let A in g)Ht[A]=g[A],A in tu&&Wt(Br,A,g[A]);y!==!1&&vn("setSelect")}}i.setSelect=_l;function Q_(g){if(T[g].show)ee&&pu(Ce[g],Ks);else if(ee&&Zn(Ce[g],Ks),ue){let A=On?Sn[0]:Sn[g];A!=null&&Ii(A,-10,-10,x,U)}}function _s(g,y,A){Jh(g,{min:y,max:A})}function Ti(g,y,A,R){y.focus!=null&&sx(g),y.show!=null&&T.forEach((O,G)=>{G>0&&(g==G||g==null)&&(O.show=y.show,Q_(G),s==2?(_s(O.facets[0].scale,null,null),_s(O.facets[1].scale,null,null)):_s(O.scale,null,null),Ur())}),A!==!1&&vn("setSeries",g,y),R&&Qo("setSeries",i,g,y)}i.setSeries=Ti;function ex(g,y){nn(N[g],y)}function tx(g,y){g.fill=dt(g.fill||null),g.dir=Mt(g.dir,-1),y=y??N.length,N.splice(y,0,g)}function nx(g){g==null?N.length=0:N.splice(g,1)}i.addBand=tx,i.setBand=ex,i.delBand=nx;function ix(g,y){T[g].alpha=y,ue&&Sn[g]!=null&&(Sn[g].style.opacity=y),ee&&Ce[g]&&(Ce[g].style.opacity=y)}let Yi,xs,qs,zr={focus:!0};function sx(g){if(g!=qs){let y=g==null,A=Xn.alpha!=1;T.forEach((R,O)=>{if(s==1||O>0){let G=y||O==0||O==g;R._focus=y?null:G,A&&ix(O,G?1:Xn.alpha)}}),qs=g,A&&Ur()}}ee&&Wi&&De(bp,ae,g=>{me._lock||(an(g),qs!=null&&Ti(null,zr,!0,tn.setSeries))});function Ai(g,y,A){let R=b[y];A&&(g=g/Tt-(R.ori==1?ne:J));let O=x;R.ori==1&&(O=U,g=O-g),R.dir==-1&&(g=O-g);let G=R._min,ie=R._max,le=g/O,pe=G+(ie-G)*le,Ae=R.distr;return Ae==3?Xr(10,pe):Ae==4?Ox(pe,R.asinh):Ae==100?R.bwd(pe):pe}function rx(g,y){let A=Ai(g,L,y);return vi(A,e[0],en,w)}i.valToIdx=g=>vi(g,e[0]),i.posToIdx=rx,i.posToVal=Ai,i.valToPos=(g,y,A)=>b[y].ori==0?r(g,b[y],A?ye:x,A?Re:0):o(g,b[y],A?Ge:U,A?se:0),i.setCursor=(g,y,A)=>{Vt=g.left,$t=g.top,$s(null,y,A)};function np(g,y){Wt(Br,Hr,Ht.left=g),Wt(Br,ta,Ht.width=y)}function ip(g,y){Wt(Br,"top",Ht.top=g),Wt(Br,na,Ht.height=y)}let Jo=I.ori==0?np:ip,Ko=I.ori==1?np:ip;function ox(){if(ee&&Se.live)for(let g=s==2?1:0;g<T.length;g++){if(g==0&&st)continue;let y=Se.values[g],A=0;for(let R in y)_t[g][A++].firstChild.nodeValue=y[R]}}function Qh(g,y){if(g!=null&&(g.idxs?g.idxs.forEach((A,R)=>{_e[R]=A}):Hx(g.idx)||_e.fill(g.idx),Se.idx=_e[0]),ee&&Se.live){for(let A=0;A<T.length;A++)(A>0||s==1&&!st)&&ax(A,_e[A]);ox()}oe=!1,y!==!1&&vn("setLegend")}i.setLegend=Qh;function ax(g,y){let A=T[g],R=g==0&&q==2?X:e[g],O;st?O=A.values(i,g,y)??F:(O=A.value(i,y==null?null:R[y],g,y),O=O==null?F:{_:O}),Se.values[g]=O}function $s(g,y,A){ep=Vt,tp=$t,[Vt,$t]=me.move(i,Vt,$t),me.left=Vt,me.top=$t,ue&&(Fr&&Ii(Fr,un(Vt),0,x,U),Nr&&Ii(Nr,0,un($t),x,U));let R,O=en>w;Yi=kt,xs=null;let G=I.ori==0?x:U,ie=I.ori==1?x:U;if(Vt<0||ln==0||O){R=me.idx=null;for(let le=0;le<T.length;le++){let pe=Sn[le];pe!=null&&Ii(pe,-10,-10,x,U)}Wi&&Ti(null,zr,!0,g==null&&tn.setSeries),Se.live&&(_e.fill(R),oe=!0)}else{let le,pe,Ae;s==1&&(le=I.ori==0?Vt:$t,pe=Ai(le,L),R=me.idx=vi(pe,e[0],en,w),Ae=z(e[0][R],I,G,0));let Ie=-10,ke=-10,it=0,Et=0,bt=!0,ft="",Ke="";for(let Xe=s==2?1:0;Xe<T.length;Xe++){let Gt=T[Xe],jt=_e[Xe],yn=jt==null?null:s==1?e[Xe][jt]:e[Xe][1][jt],Dt=me.dataIdx(i,Xe,R,pe),Qt=Dt==null?null:s==1?e[Xe][Dt]:e[Xe][1][Dt];if(oe=oe||Qt!=yn||Dt!=jt,_e[Xe]=Dt,Xe>0&&Gt.show){let qn=Dt==null?-10:Dt==R?Ae:z(s==1?e[0][Dt]:e[Xe][0][Dt],I,G,0),Pn=Qt==null?-10:W(Qt,s==1?b[Gt.scale]:b[Gt.facets[1].scale],ie,0);if(Wi&&Qt!=null){let li=I.ori==1?Vt:$t,gi=fn(Xn.dist(i,Xe,Dt,Pn,li));if(gi<Yi){let Ci=Xn.bias;if(Ci!=0){let $n=Ai(li,Gt.scale),ci=Qt>=0?1:-1,_i=$n>=0?1:-1;_i==ci&&(_i==1?Ci==1?Qt>=$n:Qt<=$n:Ci==1?Qt<=$n:Qt>=$n)&&(Yi=gi,xs=Xe)}else Yi=gi,xs=Xe}}if(oe||On){let li,gi;I.ori==0?(li=qn,gi=Pn):(li=Pn,gi=qn);let Ci,$n,ci,_i,Ri,Ln,Yn=!0,Ys=Bt.bbox;if(Ys!=null){Yn=!1;let Dn=Ys(i,Xe);ci=Dn.left,_i=Dn.top,Ci=Dn.width,$n=Dn.height}else ci=li,_i=gi,Ci=$n=Bt.size(i,Xe);if(Ln=Bt.fill(i,Xe),Ri=Bt.stroke(i,Xe),On)Xe==xs&&Yi<=Xn.prox&&(Ie=ci,ke=_i,it=Ci,Et=$n,bt=Yn,ft=Ln,Ke=Ri);else{let Dn=Sn[Xe];Dn!=null&&(Xi[Xe]=ci,qi[Xe]=_i,Cp(Dn,Ci,$n,Yn),Tp(Dn,Ln,Ri),Ii(Dn,ui(ci),ui(_i),x,U))}}}}if(On){let Xe=Xn.prox,Gt=qs==null?Yi<=Xe:Yi>Xe||xs!=qs;if(oe||Gt){let jt=Sn[0];jt!=null&&(Xi[0]=Ie,qi[0]=ke,Cp(jt,it,Et,bt),Tp(jt,ft,Ke),Ii(jt,ui(Ie),ui(ke),x,U))}}}if(Ht.show&&gs)if(g!=null){let[le,pe]=tn.scales,[Ae,Ie]=tn.match,[ke,it]=g.cursor.sync.scales,Et=g.cursor.drag;if(_n=Et._x,xn=Et._y,_n||xn){let{left:bt,top:ft,width:Ke,height:Xe}=g.select,Gt=g.scales[ke].ori,jt=g.posToVal,yn,Dt,Qt,qn,Pn,li=le!=null&&Ae(le,ke),gi=pe!=null&&Ie(pe,it);li&&_n?(Gt==0?(yn=bt,Dt=Ke):(yn=ft,Dt=Xe),Qt=b[le],qn=z(jt(yn,ke),Qt,G,0),Pn=z(jt(yn+Dt,ke),Qt,G,0),Jo(yi(qn,Pn),fn(Pn-qn))):Jo(0,G),gi&&xn?(Gt==1?(yn=bt,Dt=Ke):(yn=ft,Dt=Xe),Qt=b[pe],qn=W(jt(yn,it),Qt,ie,0),Pn=W(jt(yn+Dt,it),Qt,ie,0),Ko(yi(qn,Pn),fn(Pn-qn))):Ko(0,ie)}else nu()}else{let le=fn(ep-jd),pe=fn(tp-Qd);if(I.ori==1){let it=le;le=pe,pe=it}_n=Mn.x&&le>=Mn.dist,xn=Mn.y&&pe>=Mn.dist;let Ae=Mn.uni;Ae!=null?_n&&xn&&(_n=le>=Ae,xn=pe>=Ae,!_n&&!xn&&(pe>le?xn=!0:_n=!0)):Mn.x&&Mn.y&&(_n||xn)&&(_n=xn=!0);let Ie,ke;_n&&(I.ori==0?(Ie=kr,ke=Vt):(Ie=Or,ke=$t),Jo(yi(Ie,ke),fn(ke-Ie)),xn||Ko(0,ie)),xn&&(I.ori==1?(Ie=kr,ke=Vt):(Ie=Or,ke=$t),Ko(yi(Ie,ke),fn(ke-Ie)),_n||Jo(0,G)),!_n&&!xn&&(Jo(0,0),Ko(0,0))}if(Mn._x=_n,Mn._y=xn,g==null){if(A){if(pp!=null){let[le,pe]=tn.scales;tn.values[0]=le!=null?Ai(I.ori==0?Vt:$t,le):null,tn.values[1]=pe!=null?Ai(I.ori==1?Vt:$t,pe):null}Qo(ou,i,Vt,$t,x,U,R)}if(Wi){let le=A&&tn.setSeries,pe=Xn.prox;qs==null?Yi<=pe&&Ti(xs,zr,!0,le):Yi>pe?Ti(null,zr,!0,le):xs!=qs&&Ti(xs,zr,!0,le)}}oe&&(Se.idx=R,Qh()),y!==!1&&vn("setCursor")}let vs=null;Object.defineProperty(i,"rect",{get(){return vs==null&&jo(!1),vs}});function jo(g=!1){g?vs=null:(vs=_.getBoundingClientRect(),vn("syncRect",vs))}function sp(g,y,A,R,O,G,ie){me._lock||gs&&g!=null&&g.movementX==0&&g.movementY==0||(eu(g,y,A,R,O,G,ie,!1,g!=null),g!=null?$s(null,!0,!0):$s(y,!0,!1))}function eu(g,y,A,R,O,G,ie,le,pe){if(vs==null&&jo(!1),an(g),g!=null)A=g.clientX-vs.left,R=g.clientY-vs.top;else{if(A<0||R<0){Vt=-10,$t=-10;return}let[Ae,Ie]=tn.scales,ke=y.cursor.sync,[it,Et]=ke.values,[bt,ft]=ke.scales,[Ke,Xe]=tn.match,Gt=y.axes[0].side%2==1,jt=I.ori==0?x:U,yn=I.ori==1?x:U,Dt=Gt?G:O,Qt=Gt?O:G,qn=Gt?R:A,Pn=Gt?A:R;if(bt!=null?A=Ke(Ae,bt)?a(it,b[Ae],jt,0):-10:A=jt*(qn/Dt),ft!=null?R=Xe(Ie,ft)?a(Et,b[Ie],yn,0):-10:R=yn*(Pn/Qt),I.ori==1){let li=A;A=R,R=li}}pe&&(y==null||y.cursor.event.type==ou)&&((A<=1||A>=x-1)&&(A=Zs(A,x)),(R<=1||R>=U-1)&&(R=Zs(R,U))),le?(jd=A,Qd=R,[kr,Or]=me.move(i,A,R)):(Vt=A,$t=R)}let tu={width:0,height:0,left:0,top:0};function nu(){_l(tu,!1)}let rp,op,ap,lp;function cp(g,y,A,R,O,G,ie){gs=!0,_n=xn=Mn._x=Mn._y=!1,eu(g,y,A,R,O,G,ie,!0,!1),g!=null&&(De(au,fu,hp,!1),Qo(vp,i,kr,Or,x,U,null));let{left:le,top:pe,width:Ae,height:Ie}=Ht;rp=le,op=pe,ap=Ae,lp=Ie}function hp(g,y,A,R,O,G,ie){gs=Mn._x=Mn._y=!1,eu(g,y,A,R,O,G,ie,!1,!0);let{left:le,top:pe,width:Ae,height:Ie}=Ht,ke=Ae>0||Ie>0,it=rp!=le||op!=pe||ap!=Ae||lp!=Ie;if(ke&&it&&_l(Ht),Mn.setScale&&ke&&it){let Et=le,bt=Ae,ft=pe,Ke=Ie;if(I.ori==1&&(Et=pe,bt=Ie,ft=le,Ke=Ae),_n&&_s(L,Ai(Et,L),Ai(Et+bt,L)),xn)for(let Xe in b){let Gt=b[Xe];Xe!=L&&Gt.from==null&&Gt.min!=kt&&_s(Xe,Ai(ft+Ke,Xe),Ai(ft,Xe))}nu()}else me.lock&&(me._lock=!me._lock,$s(y,!0,g!=null));g!=null&&(et(au,fu),Qo(au,i,Vt,$t,x,U,null))}function lx(g,y,A,R,O,G,ie){if(me._lock)return;an(g);let le=gs;if(gs){let pe=!0,Ae=!0,Ie=10,ke,it;I.ori==0?(ke=_n,it=xn):(ke=xn,it=_n),ke&&it&&(pe=Vt<=Ie||Vt>=x-Ie,Ae=$t<=Ie||$t>=U-Ie),ke&&pe&&(Vt=Vt<kr?0:x),it&&Ae&&($t=$t<Or?0:U),$s(null,!0,!0),gs=!1}Vt=-10,$t=-10,_e.fill(null),$s(null,!0,!0),le&&(gs=le)}function up(g,y,A,R,O,G,ie){me._lock||(an(g),de(),nu(),g!=null&&Qo(Mp,i,Vt,$t,x,U,null))}function fp(){S.forEach(sy),Fe(i.width,i.height,!0)}js(wl,Wr,fp);let Vr={};Vr.mousedown=cp,Vr.mousemove=sp,Vr.mouseup=hp,Vr.dblclick=up,Vr.setSeries=(g,y,A,R)=>{let O=tn.match[2];A=O(i,y,A),A!=-1&&Ti(A,R,!0,!1)},ue&&(De(vp,_,cp),De(ou,_,sp),De(yp,_,g=>{an(g),jo(!1)}),De(bp,_,lx),De(Mp,_,up),yu.add(i),i.syncRect=jo);let xl=i.hooks=n.hooks||{};function vn(g,y,A){Zh?Zo.push([g,y,A]):g in xl&&xl[g].forEach(R=>{R.call(null,i,y,A)})}(n.plugins||[]).forEach(g=>{for(let y in g.hooks)xl[y]=(xl[y]||[]).concat(g.hooks[y])});let dp=(g,y,A)=>A,tn=nn({key:null,setSeries:!1,filters:{pub:Dp,sub:Dp},scales:[L,T[1]?T[1].scale:null],match:[Up,Up,dp],values:[null,null]},me.sync);tn.match.length==2&&tn.match.push(dp),me.sync=tn;let pp=tn.key,iu=Im(pp);function Qo(g,y,A,R,O,G,ie){tn.filters.pub(g,y,A,R,O,G,ie)&&iu.pub(g,y,A,R,O,G,ie)}iu.sub(i);function cx(g,y,A,R,O,G,ie){tn.filters.sub(g,y,A,R,O,G,ie)&&Vr[g](null,y,A,R,O,G,ie)}i.pub=cx;function hx(){iu.unsub(i),yu.delete(i),at.clear(),mu(wl,Wr,fp),c.remove(),ae?.remove(),vn("destroy")}i.destroy=hx;function su(){vn("init",n,e),H(e||n.data,!1),Y[L]?Jh(L,Y[L]):de(),Me=Ht.show&&(Ht.width>0||Ht.height>0),k=oe=!0,Fe(n.width,n.height)}return T.forEach(Yo),S.forEach($h),t?t instanceof HTMLElement?(t.appendChild(c),su()):t(i,su):su(),i}wn.assign=nn;wn.fmtNum=Au;wn.rangeNum=Sl;wn.rangeLog=Al;wn.rangeAsinh=Eu;wn.orient=er;wn.pxRatio=Tt;wn.join=Zx;wn.fmtDate=Ru,wn.tzDate=ov;wn.sync=Im;{wn.addGap=Hv,wn.clipGaps=Il;let n=wn.paths={points:Nm};n.linear=Om,n.stepped=Xv,n.bars=qv,n.spline=Yv}var ry=["440154","482878","3e4a89","31688e","26828e","1f9e89","35b779","6ece58","b5de2b","fde725"],oy=["053061","2166ac","4393c3","92c5de","d1e5f0","f7f7f7","fddbc7","f4a582","d6604d","b2182b","67001f"],ay=["88ccee","ddcc77","44aa99","cc6677","999933","aa4499","117733","6699cc","ee99aa","997700"],Nu=n=>[0,2,4].map(e=>parseInt(n.slice(e,e+2),16)),ly={magnitude:ry.map(Nu),signed:oy.map(Nu)},Hm=ay.map(Nu);function jn(n,e){let t=ly[n],i=Math.min(1,Math.max(0,e))*(t.length-1),s=Math.min(t.length-2,Math.floor(i));return[0,1,2].map(r=>Math.round(t[s][r]+(i-s)*(t[s+1][r]-t[s][r])))}function ku(n){let e=new Uint8Array(1024);for(let t=0;t<256;++t)e.set([...jn(n,t/255),255],4*t);return e}var jr=n=>Hm[n%Hm.length],Ms=n=>`rgb(${n[0]}, ${n[1]}, ${n[2]})`;function Gm(n,e){let t=["#0072b2","#c0392b","#007a5e","#8e44ad","#a86500","#2c3e50","#b8327a","#4d6b00","#0099a8","#7a5230"];return(e?["#56b4e9","#ff8a75","#3fd6a8","#d09bf0","#f5b942","#c9d4dd","#ff8fc7","#b5d65a","#5ee0ec","#d9ad80"]:t)[n%t.length]}var Wm=matchMedia("(prefers-color-scheme: dark)"),Xm=[],qm=()=>Xm.forEach(n=>n());Wm.addEventListener("change",qm);function Ul(){let n=document.documentElement.dataset.theme;return n===void 0?Wm.matches:n==="dark"}function $m(n){n==="light"||n==="dark"?document.documentElement.dataset.theme=n:delete document.documentElement.dataset.theme,qm()}function Fl(n){Xm.push(n)}var cy=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"\xB5"]];function tr(n,e){if(n==="")return{factor:1,name:""};let t=n==="m"||n==="m/s"||n==="s";for(let[i,s]of cy)if(!(t&&i>1)&&e>=i*(i===1&&t?.1:1))return{factor:i,name:s+n};return e>0?{factor:1e-6,name:"\xB5"+n}:{factor:1,name:n}}function Xt(n,e=3){if(!Number.isFinite(n))return"\u2013";if(n===0)return"0";let t=Math.abs(n);if(t>=1e6||t<1e-4){let[s,r]=n.toExponential(e-1).split("e");return`${Ym(s)}\xB710${Ou(Number(r))}`}let i=Math.max(0,e-1-Math.floor(Math.log10(t)));return Ym(n.toFixed(Math.min(i,8)))}function Zt(n,e,t=3){let i=tr(e,Math.abs(n));return i.name?`${Xt(n/i.factor,t)} ${i.name}`:Xt(n,t)}function zn(n){return`${n.toFixed(3)} s`}function Ym(n){return n.replace("-","\u2212")}function Ou(n){let e="\u2070\xB9\xB2\xB3\u2074\u2075\u2076\u2077\u2078\u2079";return String(n).split("").map(t=>t==="-"?"\u207B":e[Number(t)]).join("")}function Zm(n){let e=10**Math.floor(Math.log10(n));for(let t of[5,2])if(t*e<=n)return t*e;return e}var Bu=n=>getComputedStyle(document.documentElement).getPropertyValue(n).trim(),Nl=class{constructor(e,t,i,s){this.element=e;this.height=t;this.stages=i;this.on_time=s;this.plot=null;this.mark=null;this.time=0;this.remake=null;Fl(()=>this.remake?.()),new ResizeObserver(()=>this.plot?.setSize({width:this.width(),height:this.height})).observe(e)}width(){return Math.max(200,this.element.clientWidth)}draw(e,t,i){this.remake=()=>this.make(e,t,i),this.make(e,t,i)}make(e,t,i){this.plot?.destroy(),this.element.replaceChildren();let s=0;for(let f of i)for(let d=0;d<f.values.length;++d)Number.isFinite(f.values[d])&&(s=Math.max(s,Math.abs(f.values[d])));let r=e.log?{factor:1,name:e.unit}:tr(e.unit,s),o=f=>Array.from(f,d=>!Number.isFinite(d)||e.log&&!(d>0)?null:d/r.factor),a=Bu("--ink"),l={stroke:Bu("--line"),width:1},c={stroke:a,grid:l,ticks:l,font:"11px system-ui, sans-serif",labelFont:"12px system-ui, sans-serif",labelSize:20},u=`${e.what}${r.name?` [${r.name}]`:""}`,h={width:this.width(),height:this.height,scales:{x:{time:!1},y:e.log?{distr:3}:{}},axes:[{...c,label:"time [s]"},{...c,label:u,size:58,values:(f,d)=>d.map(_=>_===null?"":e.log?`10${Ou(Math.round(Math.log10(_)))}`:uy(_)),...e.log?{splits:(f,d,_,v)=>hy(_,v),filter:(f,d)=>d}:{}}],series:[{label:"time",value:(f,d)=>d==null?"\u2013":`${d.toFixed(3)} s`},...i.map((f,d)=>({label:f.label,stroke:Gm(d,Ul()),width:1.5,points:{show:!1},...f.dash?{dash:f.dash}:{},value:(_,v)=>v==null?"\u2013":`${Xt(v)}${r.name?` ${r.name}`:""}`}))],cursor:{drag:{x:!0,y:!1},points:{size:6}},hooks:{drawClear:[f=>this.draw_stages(f)],ready:[f=>{this.mark=document.createElement("div"),this.mark.className="now",f.over.append(this.mark),f.over.addEventListener("mouseleave",()=>setTimeout(()=>this.at(this.time))),f.over.addEventListener("click",d=>this.on_time(f.posToVal(d.offsetX,"x")))}],setSize:[()=>this.at(this.time)],setScale:[()=>this.at(this.time)]}};this.plot=new wn(h,[Array.from(t),...i.map(f=>o(f.values))],this.element),setTimeout(()=>this.at(this.time))}draw_stages(e){let t=e.ctx;t.save(),t.strokeStyle=t.fillStyle=Bu("--quiet"),t.font=`${Math.round(10*devicePixelRatio)}px system-ui, sans-serif`,t.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);let i=-1/0;for(let s of this.stages){if(s.start===null)continue;let r=e.valToPos(s.start,"x",!0);r<e.bbox.left-1||r>e.bbox.left+e.bbox.width||(r>e.bbox.left+1&&(t.beginPath(),t.moveTo(r,e.bbox.top),t.lineTo(r,e.bbox.top+e.bbox.height),t.stroke()),!(r<i)&&(t.fillText(s.name,r+3,e.bbox.top-3),i=r+6+t.measureText(s.name).width))}t.restore()}at(e){if(this.time=e,!this.plot||!this.mark)return;let t=this.plot.valToPos(e,"x");this.mark.style.transform=`translateX(${Math.round(t)}px)`,this.mark.hidden=!(t>=0&&t<=this.plot.over.clientWidth),this.plot.over.matches(":hover")||this.plot.setLegend({idx:this.plot.posToIdx(t)})}};function hy(n,e){let[t,i]=[Math.ceil(Math.log10(n)-1e-9),Math.floor(Math.log10(e)+1e-9)],s=Math.max(1,Math.ceil((i-t+1)/7)),r=[];for(let o=t;o<=i;o+=s)r.push(10**o);return r}function uy(n){return Math.abs(n)>=1e5?n.toExponential(1):String(Number(n.toPrecision(6))).replace("-","\u2212")}function Jm(n,e,t){let i=a=>a.reduce((l,c)=>Number.isFinite(c)?Math.max(l,Math.abs(c)):l,0),s=n.history.ledger.map((a,l)=>({...a,values:e.get(`l.${l}`)??new Float32Array(0)})),r=Math.max(0,...s.filter(a=>t.includes(a.side)).map(a=>i(a.values))),o={work:[6,3],dissipated:[8,3,2,3],scheme:[2,3]};return t.flatMap(a=>s.filter(l=>l.side===a&&i(l.values)>.001*r).map(l=>({label:`${l.name.replaceAll("_"," ")} (${a==="dissipated"?"dissipation":a})`,values:l.values,dash:o[a]})))}function Km(n){let e=n.get("l.closure")??new Float32Array(0),t=n.get("l.moved")??new Float32Array(0);return e.map((i,s)=>t[s]>0?Math.abs(i)/t[s]:0)}var zu=["displacement","horizontal displacement","vertical displacement","speed","principal stress \u03C3\u2081","principal stress \u03C3\u2083"];function jm(n,e,t){let i=a=>{let l=e.get(`${a}u`)??new Float32Array(0),c=e.get(`${a}v`)??new Float32Array(0),u=e.get(`${a}s`)??new Float32Array(0),h=(d,_)=>Float32Array.from({length:d},(v,m)=>_(m)),f=(d,_)=>.5*(u[3*d]+u[3*d+1])+_*Math.hypot(.5*(u[3*d]-u[3*d+1]),u[3*d+2]);return t==="displacement"?h(l.length/2,d=>Math.hypot(l[2*d],l[2*d+1])):t==="horizontal displacement"?h(l.length/2,d=>l[2*d]):t==="vertical displacement"?h(l.length/2,d=>l[2*d+1]):t==="speed"?h(c.length/2,d=>Math.hypot(c[2*d],c[2*d+1])):h(u.length/3,d=>f(d,t.endsWith("\u03C3\u2081")?1:-1))},s=t.includes("stress")?"Pa":t==="speed"?"m/s":"m",r=e.get("m0.time")??new Float32Array(0),o=n.history.monitors.map((a,l)=>({label:a.name,values:i(`m${l}.`)}));return{time:r,series:o,unit:s}}var xe=n=>document.getElementById(n);var Qm="scree-token";function eg(){let n=location.hash.match(/^#token=([0-9a-f]{32})$/)?.[1];return n&&(sessionStorage.setItem(Qm,n),history.replaceState(null,"",location.pathname)),n??sessionStorage.getItem(Qm)??""}function tg(n){let e=(t,i)=>xe(t).addEventListener("click",i);e("run-pause",()=>n(xe("run-pause").dataset.verb??"pause")),e("run-step",()=>n("step 1")),e("run-checkpoint",()=>n("checkpoint")),e("run-stop",()=>{confirm("End this run after its present step? It writes a checkpoint; scree resume goes on from there.")&&n("stop")})}function ng(n){let e=n==="paused",t=xe("run-pause");t.dataset.verb=e?"resume":"pause",t.textContent=e?"Resume run":"Pause run";let i=n!=="running"&&!e;for(let s of["run-pause","run-step","run-checkpoint","run-stop"])xe(s).disabled=i}var ig=n=>`${n.command}: ${n.result}${n.reason?`, ${n.reason}`:""}`;var la=[0,114,178],ca=[213,94,0],ha=[170,20,110],Vu=["no closed contact","sticking","slipping","slipping, strength failed"],rg=[[196,198,200],la,ca,ha],og=n=>(n&3)===2?1:n&4?3:2;function kl(n,e,t,i,s){let r=-1,o=i;for(let a=0;a<n.state.length;++a){if(s&&s.blocks.some((c,u)=>n.blocks[3*a+u]!==c))continue;let l=Math.hypot(n.position[2*a]-e,n.position[2*a+1]-t);l<=o&&([r,o]=[a,l])}return r}var aa=(n,e)=>({blocks:[n.blocks[3*e],n.blocks[3*e+1],n.blocks[3*e+2]],place:[n.position[2*e],n.position[2*e+1]]});function ag(n,e,t){let[i,s,r]=aa(e,t).blocks,[o,a]=[e.force[2*t],e.force[2*t+1]],l=n.model.joints.laws[r],[c,u]=aa(e,t).place;return[["Corner of",n.model.blocks[i]?.name],["Edge of",n.model.blocks[s]?.name],["Joint",l?`${l.name}, \u03C6 = ${Xt(l.friction_deg)}\xB0`:void 0],["State",Vu[og(e.state[t])]],["Normal force",`${Zt(o,"N")}/m`],["Shear force",`${Zt(a,"N")}/m`],["Shear / normal",o>0?`${Xt(Math.abs(a)/o)}${l?` (tan \u03C6 = ${Xt(Math.tan(l.friction_deg*Math.PI/180))})`:""}`:void 0],["Slip",Zt(e.slip[t],"m")],["At",`${(c+n.origin[0]).toFixed(2)}, ${(u+n.origin[1]).toFixed(2)} m`]]}var sg=new WeakMap;function Hu(n,e){if(!n)return 0;let t=sg.get(n);if(!t){sg.set(n,t=new Map);for(let i=0;i<n.state.length;++i)for(let s of[0,1]){let r=n.blocks[3*i+s];t.set(r,Math.max(t.get(r)??0,og(n.state[i])))}}return t.get(e)??0}function Qe(n,e,t){let i=document.createElement(n);return e!==void 0&&(i.textContent=e),t&&(i.className=t),i}function nr(n,e){let t=Qe("dl");for(let[i,s]of e)s===void 0||s===""||t.append(Qe("dt",i),Qe("dd",s));n.replaceChildren(t)}function ua(n,e,t){let i=Qe("table");i.append(Qe("caption",t));let s=Qe("tr");for(let a of n){let l=Qe("th",a);l.scope="col",s.append(l)}let r=Qe("thead");r.append(s);let o=Qe("tbody");for(let a of e){let l=Qe("tr");for(let c of a)l.append(Qe("td",c));o.append(l)}return i.append(r,o),i}var sn=(n,e)=>typeof n?.[e]=="number"?n[e]:void 0,Qn=(n,e)=>typeof n?.[e]=="string"?n[e]:void 0,fa=(n,e)=>n&&typeof n[e]=="object"?n[e]:null,Ki=n=>n?.toLocaleString("en").replaceAll(","," "),fy={done:"done",interrupted:"interrupted",not_converged:"did not converge",non_finite:"ended with numbers that are not finite"};function Gu(n){let e=Qn(n.found,"status")??String(n.asked.status??"");return fy[e]??(e||"has not ended")}function lg(n,e){let t=n.asked,i=[["Run",n.folder],["Command line",Qn(t,"command_line")],["Settings changed",n.asked.set.join(", ")],["Scree",[Qn(t,"version"),Qn(t,"commit")].filter(Boolean).join(", commit ")],["Built with",[Qn(t,"compiler"),Qn(t,"instruction_set")].filter(Boolean).join(", ")],["Libraries",n.asked.libraries.map(([o,a])=>`${o} ${a}`).join(", ")],["Threads",Ki(sn(n.found,"threads"))],["Resumed at",Qn(t,"resumed")],["SHA-256 of the case",Qn(t,"case_sha256")]];nr(e,i),e.append(ua(["Stage","Time integration","Start","Planned"],n.stages.map(o=>[o.name,o.integrator,o.start===null?"not reached":zn(o.start),zn(o.duration)]),"Stages"),ua(["Material","Density","Young's modulus","Poisson's ratio"],n.model.materials.map(o=>[o.name,`${Xt(o.density,4)} kg/m\xB3`,Zt(o.young,"Pa"),Xt(o.poisson)]),"Materials"),ua(["Joint","Friction","Cohesion","Tensile strength"],n.model.joints.laws.map(o=>[o.name,`${Xt(o.friction_deg)}\xB0`,Zt(o.cohesion,"Pa"),o.tensile_strength===null?"unlimited":Zt(o.tensile_strength,"Pa")]),"Joint laws"));let s=Qe("details");s.append(Qe("summary","Case file"));let r=Qe("pre",n.asked.case);r.tabIndex=0,r.setAttribute("aria-label","Text of the case file"),s.append(r),e.append(s)}function Wu(n,e){let t=n.found,i=fa(t,"ledger"),s=fa(t,"wall_seconds"),r=fa(t,"friction"),o=sn(i,"relative_closure"),a=sn(i,"scheme_passed_share"),l=sn(t,"peak_memory_bytes"),c=n.frames.list[n.frames.list.length-1];nr(e,[["Status",Gu(n)],["Reason",Qn(t,"reason")],["Simulated time",zn(sn(t,"final_time")??c.time)],["Steps",Ki(sn(t,"steps")??c.step)],["Step cuts",Ki(sn(t,"cuts"))],["Open-close passes",Ki(sn(t,"open_close_passes"))],["Blocks, elements (end)",t?`${Ki(sn(t,"blocks_count"))}, ${Ki(sn(t,"elements"))}`:Ki(n.model.blocks.length)],["Unknowns (end)",Ki(sn(t,"unknowns"))],["Contacts (end)",Ki(sn(t,"contacts"))],["Energy moved",sn(i,"moved")===void 0?void 0:Zt(sn(i,"moved"),"J")],["Ledger closure",o===void 0?void 0:`${Xt(o)} of ${Qn(i,"relative_closure_of")??"the energy moved"}`],["Largest scheme column",a===void 0?void 0:`${Xt(100*a)} % of the energy passed`],["Friction, worst ratio",sn(r,"worst_ratio")===void 0?void 0:Xt(sn(r,"worst_ratio"))],["Wall time",sn(s,"total")===void 0?void 0:`${Xt(sn(s,"total"))} s`],["Peak memory",l===void 0?void 0:`${Xt(l/1e6)} MB`],["State hash",Qn(t,"state_hash")]]),t||e.append(Qe("p","The run has no summary: it goes on, or it was killed.","note"));let u=(Array.isArray(t?.blocks)?t.blocks:[]).map(h=>({name:Qn(h,"name")??"",method:Qn(h,"method")??"",displacement:sn(h,"displacement")??0})).sort((h,f)=>f.displacement-h.displacement).slice(0,8);u.length>0&&e.append(ua(["Block","Method","Mean displacement"],u.map(h=>[h.name,h.method,Zt(h.displacement,"m")]),"Blocks that moved farthest")),dy(i,n,e)}function dy(n,e,t){let i=fa(n,"columns");if(!i)return;let s=[];for(let a of e.history.ledger){let l=sn(fa(i,a.side),a.name);l!==void 0&&l!==0&&s.push([a.name.replaceAll("_"," "),a.side,Zt(l,"J"),a.meaning])}let r=Qe("details");r.append(Qe("summary","Energy ledger at the end, column by column"));let o=Qe("div",void 0,"scroll");o.tabIndex=0,o.setAttribute("role","region"),o.setAttribute("aria-label","Energy ledger at the end"),o.append(ua(["Column","Side","Value","Meaning"],s,"Columns that are not zero")),r.append(o),t.append(r)}var py=new Set(["transfer"]);function Xu(n,e,t){let i=[...new Set(n.events.map(l=>l[1]))],s=new Set(i.filter(l=>!py.has(l))),r=Qe("ol",void 0,"events scroll");r.tabIndex=0,r.setAttribute("aria-label","Events and warnings");let o=()=>{r.replaceChildren(...n.events.filter(l=>s.has(l[1])).map(([l,c,u])=>{let h=Qe("li",void 0,c==="warning"||c==="not_converged"?"warning":""),f=Qe("button",zn(l),"link");return f.type="button",f.title="Show this instant",f.addEventListener("click",()=>t(l)),h.append(f,Qe("span",c.replaceAll("_"," "),"kind"),Qe("span",u)),h})),r.childElementCount===0&&r.append(Qe("li","none"))},a=Qe("fieldset",void 0,"kinds");a.append(Qe("legend","Kinds"));for(let l of i){let c=Qe("label"),u=Qe("input");u.type="checkbox",u.checked=s.has(l),u.addEventListener("change",()=>{u.checked?s.add(l):s.delete(l),o()}),c.append(u,` ${l.replaceAll("_"," ")} (${n.events.filter(h=>h[1]===l).length})`),a.append(c)}o(),e.replaceChildren(...i.length>0?[a,r]:[Qe("p","The run had no events.")])}var my=9,gy=.1,Ol=class{constructor(e,t){this.run=e;this.changed=t;this.chosen=null;this.contacts=null}get place(){return this.chosen?[this.chosen.place]:[]}clicked(e,t,i){let s=this.contacts&&i>0?kl(this.contacts,e,t,my/i):-1;return this.choose(s),s>=0&&xe("contact-box").scrollIntoView({block:"nearest"}),s>=0}next(e){let t=this.contacts;if(!t)return;let i=Array.from(t.state.keys()).filter(r=>e<0||t.blocks[3*r]===e||t.blocks[3*r+1]===e),s=this.chosen?kl(t,...this.chosen.place,1/0,this.chosen):-1;this.choose(i.length>0?i[(i.indexOf(s)+1)%i.length]:-1)}choose(e){this.chosen=e<0?null:aa(this.contacts,e),this.show(this.contacts),this.changed()}show(e){this.contacts=e;let t=xe("contact-facts");if(!this.chosen||!e)return t.replaceChildren();let[i,s,r,o]=this.run.frames.bounds,a=kl(e,...this.chosen.place,gy*Math.hypot(r-i,o-s),this.chosen);if(a<0)return nr(t,[["State","open at this instant"]]);this.chosen=aa(e,a),nr(t,ag(this.run,e,a))}};var $u=(n,e)=>Math.sqrt(n*n+e*e),Yu=(n,e)=>.5*(n.stress[3*e]+n.stress[3*e+1]),qu=(n,e)=>$u(.5*(n.stress[3*e]-n.stress[3*e+1]),n.stress[3*e+2]),ws=[{id:"displacement",label:"displacement",unit:"m",kind:"magnitude",point:(n,e)=>$u(n.displacement[2*e],n.displacement[2*e+1])},{id:"ux",label:"horizontal displacement",unit:"m",kind:"signed",point:(n,e)=>n.displacement[2*e]},{id:"uy",label:"vertical displacement",unit:"m",kind:"signed",point:(n,e)=>n.displacement[2*e+1]},{id:"speed",label:"speed",unit:"m/s",kind:"magnitude",point:(n,e)=>$u(n.velocity[2*e],n.velocity[2*e+1])},{id:"vx",label:"horizontal velocity",unit:"m/s",kind:"signed",point:(n,e)=>n.velocity[2*e]},{id:"vy",label:"vertical velocity",unit:"m/s",kind:"signed",point:(n,e)=>n.velocity[2*e+1]},{id:"s1",label:"principal stress \u03C3\u2081 (larger)",unit:"Pa",kind:"signed",point:(n,e)=>Yu(n,e)+qu(n,e)},{id:"s3",label:"principal stress \u03C3\u2083 (smaller)",unit:"Pa",kind:"signed",point:(n,e)=>Yu(n,e)-qu(n,e)},{id:"shear",label:"maximum shear stress",unit:"Pa",kind:"magnitude",point:qu},{id:"sxx",label:"stress \u03C3xx",unit:"Pa",kind:"signed",point:(n,e)=>n.stress[3*e]},{id:"syy",label:"stress \u03C3yy",unit:"Pa",kind:"signed",point:(n,e)=>n.stress[3*e+1]},{id:"sxy",label:"shear stress \u03C3xy",unit:"Pa",kind:"signed",point:(n,e)=>n.stress[3*e+2]},{id:"method",label:"method",unit:"",kind:"names",cell:(n,e,t)=>n.method[t],names:n=>n.model.methods.map(e=>e.toUpperCase())},{id:"integrator",label:"time integrator",unit:"",kind:"names",cell:(n,e,t)=>e.integrator[t],names:()=>["explicit","implicit"]},{id:"joint",label:"joint state of the blocks",unit:"",kind:"names",cell:(n,e,t)=>Hu(e.contacts,n.block[t]),names:()=>Vu,colours:rg},{id:"material",label:"material",unit:"",kind:"names",cell:(n,e,t)=>n.material[t],names:n=>n.model.materials.map(e=>e.name)},{id:"block",label:"block",unit:"",kind:"names",cell:(n,e,t)=>n.block[t]}],Bl=3e38;function _y(n,e,t,i){if(n.id==="joint")return t.contacts?Hu(t.contacts,e.block[i]):Bl;let s=n.id==="mean_stress"?Yu:n.unit==="Pa"?n.point:void 0;if(!s||t.stress.length===0)return Bl;let[r,o]=[e.offsets[i],e.offsets[i+1]],a=0;for(let l=r;l<o;++l)a+=s(t,e.cells[l])/(o-r);return a}var ir=[...ws.filter(n=>n.id==="speed"),{id:"mean_stress",label:"mean stress",unit:"Pa",kind:"signed"},...ws.filter(n=>["s1","s3","shear","sxx","syy","sxy","joint","integrator"].includes(n.id))].map(({point:n,...e})=>({...e,cell:(t,i,s)=>i.scalar_field===e.id?i.scalar[s]:_y({...e,point:n},t,i,s)})),Zu=(n,e,t)=>!ir.includes(n)||e.block.length===0||n.cell(e,t,0)<Bl/2,zl=[...ws.filter(n=>["displacement","ux","uy"].includes(n.id)),...ir,...ws.filter(n=>["method","material","block"].includes(n.id))];function cg(n,e,t,i){let s=n.point?new Float32Array(e.origin.length/2):null;if(s)for(let r=0;r<s.length;++r)s[r]=n.point(t,r);for(let r=0;r+1<e.offsets.length;++r){let o=n.cell?n.cell(e,t,r):0;for(let a=e.offsets[r];a<e.offsets[r+1];++a)i[a]=s?s[e.cells[a]]:o}}function hg(n,e,t,i){let s=[];for(let l=0;l+1<e.offsets.length;++l)if(!i(e.block[l]))for(let c=e.offsets[l];c<e.offsets[l+1];++c)Number.isFinite(t[c])&&t[c]<Bl/2&&s.push(Math.abs(t[c]));s.sort((l,c)=>l-c);let r=n.unit==="Pa"?.99:1,o=s.length>0?s[Math.min(s.length-1,Math.floor(r*s.length))]:0,a=o>0?o:1;return[n.kind==="signed"?-a:0,a]}function ju(n,e,t=2){let i=e&&e.length,s=i?e[0]*t:n.length,r=fg(n,0,s,t,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(i&&(r=My(n,e,r,t)),n.length>80*t){a=n[0],l=n[1];let u=a,h=l;for(let f=t;f<s;f+=t){let d=n[f],_=n[f+1];d<a&&(a=d),_<l&&(l=_),d>u&&(u=d),_>h&&(h=_)}c=Math.max(u-a,h-l),c=c!==0?32767/c:0}return pa(r,o,t,a,l,c,0),o}function fg(n,e,t,i,s){let r;if(s===Dy(n,e,t,i)>0)for(let o=e;o<t;o+=i)r=ug(o/i|0,n[o],n[o+1],r);else for(let o=t-i;o>=e;o-=i)r=ug(o/i|0,n[o],n[o+1],r);return r&&Qr(r,r.next)&&(ga(r),r=r.next),r}function sr(n,e){if(!n)return n;e||(e=n);let t=n,i;do if(i=!1,!t.steiner&&(Qr(t,t.next)||Jt(t.prev,t,t.next)===0)){if(ga(t),t=e=t.prev,t===t.next)break;i=!0}else t=t.next;while(i||t!==e);return e}function pa(n,e,t,i,s,r,o){if(!n)return;!o&&r&&Ay(n,i,s,r);let a=n;for(;n.prev!==n.next;){let l=n.prev,c=n.next;if(r?vy(n,i,s,r):xy(n)){e.push(l.i,n.i,c.i),ga(n),n=c.next,a=c.next;continue}if(n=c,n===a){o?o===1?(n=yy(sr(n),e),pa(n,e,t,i,s,r,2)):o===2&&by(n,e,t,i,s,r):pa(sr(n),e,t,i,s,r,1);break}}}function xy(n){let e=n.prev,t=n,i=n.next;if(Jt(e,t,i)>=0)return!1;let s=e.x,r=t.x,o=i.x,a=e.y,l=t.y,c=i.y,u=Math.min(s,r,o),h=Math.min(a,l,c),f=Math.max(s,r,o),d=Math.max(a,l,c),_=i.next;for(;_!==e;){if(_.x>=u&&_.x<=f&&_.y>=h&&_.y<=d&&da(s,a,r,l,o,c,_.x,_.y)&&Jt(_.prev,_,_.next)>=0)return!1;_=_.next}return!0}function vy(n,e,t,i){let s=n.prev,r=n,o=n.next;if(Jt(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,u=s.y,h=r.y,f=o.y,d=Math.min(a,l,c),_=Math.min(u,h,f),v=Math.max(a,l,c),m=Math.max(u,h,f),p=Ju(d,_,e,t,i),T=Ju(v,m,e,t,i),S=n.prevZ,b=n.nextZ;for(;S&&S.z>=p&&b&&b.z<=T;){if(S.x>=d&&S.x<=v&&S.y>=_&&S.y<=m&&S!==s&&S!==o&&da(a,u,l,h,c,f,S.x,S.y)&&Jt(S.prev,S,S.next)>=0||(S=S.prevZ,b.x>=d&&b.x<=v&&b.y>=_&&b.y<=m&&b!==s&&b!==o&&da(a,u,l,h,c,f,b.x,b.y)&&Jt(b.prev,b,b.next)>=0))return!1;b=b.nextZ}for(;S&&S.z>=p;){if(S.x>=d&&S.x<=v&&S.y>=_&&S.y<=m&&S!==s&&S!==o&&da(a,u,l,h,c,f,S.x,S.y)&&Jt(S.prev,S,S.next)>=0)return!1;S=S.prevZ}for(;b&&b.z<=T;){if(b.x>=d&&b.x<=v&&b.y>=_&&b.y<=m&&b!==s&&b!==o&&da(a,u,l,h,c,f,b.x,b.y)&&Jt(b.prev,b,b.next)>=0)return!1;b=b.nextZ}return!0}function yy(n,e){let t=n;do{let i=t.prev,s=t.next.next;!Qr(i,s)&&pg(i,t,t.next,s)&&ma(i,s)&&ma(s,i)&&(e.push(i.i,t.i,s.i),ga(t),ga(t.next),t=n=s),t=t.next}while(t!==n);return sr(t)}function by(n,e,t,i,s,r){let o=n;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&Iy(o,a)){let l=mg(o,a);o=sr(o,o.next),l=sr(l,l.next),pa(o,e,t,i,s,r,0),pa(l,e,t,i,s,r,0);return}a=a.next}o=o.next}while(o!==n)}function My(n,e,t,i){let s=[];for(let r=0,o=e.length;r<o;r++){let a=e[r]*i,l=r<o-1?e[r+1]*i:n.length,c=fg(n,a,l,i,!1);c===c.next&&(c.steiner=!0),s.push(Ry(c))}s.sort(wy);for(let r=0;r<s.length;r++)t=Sy(s[r],t);return t}function wy(n,e){let t=n.x-e.x;if(t===0&&(t=n.y-e.y,t===0)){let i=(n.next.y-n.y)/(n.next.x-n.x),s=(e.next.y-e.y)/(e.next.x-e.x);t=i-s}return t}function Sy(n,e){let t=Ey(n,e);if(!t)return e;let i=mg(t,n);return sr(i,i.next),sr(t,t.next)}function Ey(n,e){let t=e,i=n.x,s=n.y,r=-1/0,o;if(Qr(n,t))return t;do{if(Qr(n,t.next))return t.next;if(s<=t.y&&s>=t.next.y&&t.next.y!==t.y){let h=t.x+(s-t.y)*(t.next.x-t.x)/(t.next.y-t.y);if(h<=i&&h>r&&(r=h,o=t.x<t.next.x?t:t.next,h===i))return o}t=t.next}while(t!==e);if(!o)return null;let a=o,l=o.x,c=o.y,u=1/0;t=o;do{if(i>=t.x&&t.x>=l&&i!==t.x&&dg(s<c?i:r,s,l,c,s<c?r:i,s,t.x,t.y)){let h=Math.abs(s-t.y)/(i-t.x);ma(t,n)&&(h<u||h===u&&(t.x>o.x||t.x===o.x&&Ty(o,t)))&&(o=t,u=h)}t=t.next}while(t!==a);return o}function Ty(n,e){return Jt(n.prev,n,e.prev)<0&&Jt(e.next,n,n.next)<0}function Ay(n,e,t,i){let s=n;do s.z===0&&(s.z=Ju(s.x,s.y,e,t,i)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==n);s.prevZ.nextZ=null,s.prevZ=null,Cy(s)}function Cy(n){let e,t=1;do{let i=n,s;n=null;let r=null;for(e=0;i;){e++;let o=i,a=0;for(let c=0;c<t&&(a++,o=o.nextZ,!!o);c++);let l=t;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||i.z<=o.z)?(s=i,i=i.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:n=s,s.prevZ=r,r=s;i=o}r.nextZ=null,t*=2}while(e>1);return n}function Ju(n,e,t,i,s){return n=(n-t)*s|0,e=(e-i)*s|0,n=(n|n<<8)&16711935,n=(n|n<<4)&252645135,n=(n|n<<2)&858993459,n=(n|n<<1)&1431655765,e=(e|e<<8)&16711935,e=(e|e<<4)&252645135,e=(e|e<<2)&858993459,e=(e|e<<1)&1431655765,n|e<<1}function Ry(n){let e=n,t=n;do(e.x<t.x||e.x===t.x&&e.y<t.y)&&(t=e),e=e.next;while(e!==n);return t}function dg(n,e,t,i,s,r,o,a){return(s-o)*(e-a)>=(n-o)*(r-a)&&(n-o)*(i-a)>=(t-o)*(e-a)&&(t-o)*(r-a)>=(s-o)*(i-a)}function da(n,e,t,i,s,r,o,a){return!(n===o&&e===a)&&dg(n,e,t,i,s,r,o,a)}function Iy(n,e){return n.next.i!==e.i&&n.prev.i!==e.i&&!Py(n,e)&&(ma(n,e)&&ma(e,n)&&Ly(n,e)&&(Jt(n.prev,n,e.prev)||Jt(n,e.prev,e))||Qr(n,e)&&Jt(n.prev,n,n.next)>0&&Jt(e.prev,e,e.next)>0)}function Jt(n,e,t){return(e.y-n.y)*(t.x-e.x)-(e.x-n.x)*(t.y-e.y)}function Qr(n,e){return n.x===e.x&&n.y===e.y}function pg(n,e,t,i){let s=Hl(Jt(n,e,t)),r=Hl(Jt(n,e,i)),o=Hl(Jt(t,i,n)),a=Hl(Jt(t,i,e));return!!(s!==r&&o!==a||s===0&&Vl(n,t,e)||r===0&&Vl(n,i,e)||o===0&&Vl(t,n,i)||a===0&&Vl(t,e,i))}function Vl(n,e,t){return e.x<=Math.max(n.x,t.x)&&e.x>=Math.min(n.x,t.x)&&e.y<=Math.max(n.y,t.y)&&e.y>=Math.min(n.y,t.y)}function Hl(n){return n>0?1:n<0?-1:0}function Py(n,e){let t=n;do{if(t.i!==n.i&&t.next.i!==n.i&&t.i!==e.i&&t.next.i!==e.i&&pg(t,t.next,n,e))return!0;t=t.next}while(t!==n);return!1}function ma(n,e){return Jt(n.prev,n,n.next)<0?Jt(n,e,n.next)>=0&&Jt(n,n.prev,e)>=0:Jt(n,e,n.prev)<0||Jt(n,n.next,e)<0}function Ly(n,e){let t=n,i=!1,s=(n.x+e.x)/2,r=(n.y+e.y)/2;do t.y>r!=t.next.y>r&&t.next.y!==t.y&&s<(t.next.x-t.x)*(r-t.y)/(t.next.y-t.y)+t.x&&(i=!i),t=t.next;while(t!==n);return i}function mg(n,e){let t=Ku(n.i,n.x,n.y),i=Ku(e.i,e.x,e.y),s=n.next,r=e.prev;return n.next=e,e.prev=n,t.next=s,s.prev=t,i.next=t,t.prev=i,r.next=i,i.prev=r,i}function ug(n,e,t,i){let s=Ku(n,e,t);return i?(s.next=i.next,s.prev=i,i.next.prev=s,i.next=s):(s.prev=s,s.next=s),s}function ga(n){n.next.prev=n.prev,n.prev.next=n.next,n.prevZ&&(n.prevZ.nextZ=n.nextZ),n.nextZ&&(n.nextZ.prevZ=n.prevZ)}function Ku(n,e,t){return{i:n,x:e,y:t,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function Dy(n,e,t,i){let s=0;for(let r=e,o=t-i;r<t;r+=i)s+=(n[o]-n[r])*(n[r+1]+n[o+1]),o=r;return s}function gg(n){let e=[];for(let t=0;t+1<n.offsets.length;++t){let i=n.offsets[t],s=n.offsets[t+1]-i;if(s===3){e.push(i,i+1,i+2);continue}let r=[];for(let o=0;o<s;++o){let a=n.cells[i+o];r.push(n.origin[2*a],n.origin[2*a+1])}for(let o of ju(r))e.push(i+o)}return new Uint32Array(e)}function _g(n){let e=0;for(let a of n.origin)e=Math.max(e,Math.abs(a));let t=Math.max(1e-6*e,1e-30),i=new Map,s=(a,l)=>{let c=`${a} ${Math.round(n.origin[2*l]/t)} ${Math.round(n.origin[2*l+1]/t)}`,u=i.get(c);return u===void 0&&i.set(c,u=i.size),u},r=new Map;for(let a=0;a+1<n.offsets.length;++a){let l=n.offsets[a],c=n.offsets[a+1];for(let u=l;u<c;++u){let h=n.cells[u],f=n.cells[u+1<c?u+1:l],d=s(n.block[a],h),_=s(n.block[a],f),v=d<_?`${d} ${_}`:`${_} ${d}`,m=r.get(v);m?m.count+=1:r.set(v,{a:h,b:f,block:n.block[a],count:1})}}let o=[...r.values()].filter(a=>a.count===1);return{edges:new Uint32Array(o.flatMap(a=>[a.a,a.b])),block:new Int32Array(o.map(a=>a.block))}}function xg(n,e,t,i){for(let s=0;s+1<n.offsets.length;++s){let r=n.offsets[s],o=n.offsets[s+1],a=!1;for(let l=r,c=o-1;l<o;c=l++){let u=2*n.cells[l],h=2*n.cells[c],f=e[u+1],d=e[h+1];f>i!=d>i&&t<e[u]+(i-f)/(d-f)*(e[h]-e[u])&&(a=!a)}if(a)return s}return-1}function Gl(n){let e=new Float64Array(n.offsets.length-1);for(let t=0;t<e.length;++t){let i=n.offsets[t],s=n.offsets[t+1],r=0;for(let o=i,a=s-1;o<s;a=o++){let l=2*n.cells[o],c=2*n.cells[a];r+=n.origin[c]*n.origin[l+1]-n.origin[l]*n.origin[c+1]}e[t]=Math.abs(.5*r)}return e}var Pi=class{constructor(){this.ends=[];this.tint=[]}add(e,t,i,s,r){this.ends.push(e,t,i,s),this.tint.push(...r)}done(){return{ends:new Float32Array(this.ends),tint:new Uint8Array(this.tint)}}},Qu=[24,82,160],ef=[200,30,30],rr=[0,96,200];function vg(n){let e=n.filter(Number.isFinite).sort((t,i)=>t-i);return e.length>0?e[Math.min(e.length-1,Math.floor(.98*e.length))]:0}function yg(n,e,t,i,s){let r=new Set,o=[];for(let h=0;h+1<n.offsets.length;++h){if(i(n.block[h]))continue;let f=n.offsets[h],d=n.offsets[h+1],_={x:0,y:0,xx:0,yy:0,xy:0};for(let m=f;m<d;++m){let p=n.cells[m];_.x+=t[2*p]/(d-f),_.y+=t[2*p+1]/(d-f),_.xx+=e.stress[3*p]/(d-f),_.yy+=e.stress[3*p+1]/(d-f),_.xy+=e.stress[3*p+2]/(d-f)}let v=`${Math.floor(_.x/s)} ${Math.floor(_.y/s)}`;r.has(v)||(r.add(v),o.push(_))}let a=o.map(h=>{let f=.5*(h.xx+h.yy),d=Math.hypot(.5*(h.xx-h.yy),h.xy),_=.5*Math.atan2(2*h.xy,h.xx-h.yy);return{...h,s1:f+d,s3:f-d,angle:_}}),l=vg(a.map(h=>Math.max(Math.abs(h.s1),Math.abs(h.s3)))),c=.55*s,u=new Pi;if(l>0)for(let h of a)for(let[f,d]of[[h.s1,h.angle],[h.s3,h.angle+.5*Math.PI]]){let _=c*Math.min(1.5,Math.abs(f)/l),v=_*Math.cos(d),m=_*Math.sin(d);u.add(h.x-v,h.y-m,h.x+v,h.y+m,f>0?ef:Qu)}return{...u.done(),stress:l,arm:c}}function bg(n,e){let t=n.state.length,i=a=>Math.hypot(n.force[2*a],n.force[2*a+1]),s=vg(Array.from({length:t},(a,l)=>i(l))),r={force:s,length:e,sticking:0,slipping:0,failed:0},o=new Pi;for(let a=0;a<t;++a){let l=n.state[a];(l&3)===2?r.sticking+=1:r.slipping+=1,l&4&&(r.failed+=1);let[c,u]=[n.normal[2*a],n.normal[2*a+1]],[h,f]=[n.force[2*a],n.force[2*a+1]],d=s>0?.5*e/Math.max(s,i(a)):0,[_,v]=[d*(h*c-f*u),d*(h*u+f*c)],[m,p]=[n.position[2*a],n.position[2*a+1]];o.add(m-_,p-v,m+_,p+v,(l&3)===2?la:l&4?ha:ca)}return{...o.done(),...r}}function tf(n,e){let t=Array.from(n.slip,Math.abs),i=t.reduce((r,o)=>Number.isFinite(o)&&o>r?o:r,0),s=new Pi;return t.forEach((r,o)=>{let[a,l]=[-e*n.normal[2*o+1],e*n.normal[2*o]],[c,u]=[n.position[2*o],n.position[2*o+1]];s.add(c-a,u-l,c+a,u+l,jn("magnitude",i>0?r/i:0))}),{...s.done(),most:i}}function Mg(n){let e=n.force.reduce((i,s)=>Math.abs(s)>i?Math.abs(s):i,0),t=new Pi;for(let i=0;i+1<n.bolt.length;++i)n.bolt[i]===n.bolt[i+1]&&t.add(n.position[2*i],n.position[2*i+1],n.position[2*i+2],n.position[2*i+3],jn("magnitude",e>0?Math.abs(n.force[i])/e:0));return{...t.done(),most:e}}function wg(n,e){let t=new Pi,[i,,s]=n.frames.bounds;for(let{line:r}of n.model.water??[]){let o=r.length-2,a=[Math.min(i,r[0]),r[1],...r,Math.max(s,r[o]),r[o+1]];for(let h=0;h+3<a.length;h+=2)t.add(a[h],a[h+1],a[h+2],a[h+3],rr);let[l,c,u]=[-1,0,0];for(let h=0;h+3<a.length;h+=2){let[f,d]=[Math.max(i,a[h]),Math.min(s,a[h+2])];d-f<=l||(l=d-f,c=.5*(f+d),u=a[h+1]+(a[h+3]-a[h+1])*(c-a[h])/Math.max(a[h+2]-a[h],1e-12))}t.add(c,u,c-.6*e,u+e,rr),t.add(c-.6*e,u+e,c+.6*e,u+e,rr),t.add(c+.6*e,u+e,c,u,rr);for(let[h,f]of[[.25,.45],[.5,.25]])t.add(c-f*e,u-h*e,c+f*e,u-h*e,rr)}return t.done()}function Sg(n){let e=[];for(let t of n.model.blocks)for(let i of t.rings)for(let s=0;s<i.length;s+=2){let r=(s+2)%i.length;e.push(i[s],i[s+1],i[r],i[r+1])}return Float32Array.from(e)}function Eg(n,e,t){let i=new Pi;for(let[s,r,o,a,l]of n.model.edges??[]){let c=Math.hypot(o-s,a-r);if(!(c>0))continue;let[u,h]=[(o-s)/c,(a-r)/c],f=(v,m)=>[s+v*u+m*h,r+v*h-m*u],d=l?0:.35*t;i.add(s,r,o,a,e),l||i.add(...f(0,d),...f(c,d),e);let _=Math.min(400,Math.max(1,Math.round(c/(.8*t))));for(let v=0;v<_;++v){let m=(v+.5)*c/_;i.add(...f(m,d),...f(m-.35*t,d+.35*t),e)}}for(let[s,r,o,a]of n.model.supports){let l=(h,f)=>a?[s+f*t,r-h*t]:[s-h*t,r+f*t],c=(h,f,d,_)=>i.add(...l(h,f),...l(d,_),e),u=o&&a?1:1.25;c(0,0,1,-.6),c(0,0,1,.6),c(1,-.6,1,.6),c(u,-.8,u,.8);for(let h of[-.6,-.2,.2,.6])c(u,h,u+.3,h-.25)}return i.done()}function nf(n,e,t){let i=new Pi;for(let[s,r]of n)for(let[o,a,l,c]of[[1,0,0,1],[0,1,-1,0],[-1,0,0,-1],[0,-1,1,0]])i.add(s+o*t,r+a*t,s+l*t,r+c*t,e);return i.done()}function Tg(n){let e=new Pi,t=i=>i.forEach(([s,r,o,a,l])=>e.add(s,r,o,a,jr(l+3)));return t(n.model.joints.lines),t(n.model.joints.cracks),e.done()}function Ag(n,e,t){if(n.kind==="names")return{what:n.label,ticks:[],names:t};let i=tr(n.unit,Math.max(Math.abs(e[0]),Math.abs(e[1]))),s=[0,.25,.5,.75,1].map(r=>Xt((e[0]+r*(e[1]-e[0]))/i.factor));return{what:`${n.label} [${i.name}]${n.unit==="Pa"&&n.kind==="signed"?", tension positive":""}`,ticks:s,names:[]}}function Cg(n,e,t){if(e.kind==="names"){let o=Qe("div",void 0,"names");for(let[a,l]of t.names){let c=Qe("span"),u=Qe("span",void 0,"swatch");u.style.background=Ms(l),c.append(u,a),o.append(c)}n.replaceChildren(Qe("div",t.what,"what"),o);return}let i=e.kind,s=Qe("div",void 0,"ramp");s.style.background=`linear-gradient(to right, ${Array.from({length:17},(o,a)=>Ms(jn(i,a/16))).join(", ")})`;let r=Qe("div",void 0,"ticks");for(let o of t.ticks)r.append(Qe("span",o));n.replaceChildren(s,r,Qe("div",t.what,"what"))}var Wl=class n{constructor(e){this.channel=new BroadcastChannel("scree-pair");this.channel.onmessage=t=>e(t.data)}static find(e){return window.parent===window?null:new n(e)}tell(e){this.channel.postMessage(e)}};function Rg(n,e){let t={...n};for(let[i,[s,r]]of Object.entries(e))t[i]=[Math.min(s,t[i]?.[0]??s),Math.max(r,t[i]?.[1]??r)];return t}function Ig(n){return new Promise((e,t)=>n.toBlob(i=>i?e(i):t(new Error("the picture is too large to save")),"image/png"))}function sf(n,e,t=document.createElement("canvas")){let i=n.width/Math.max(1,n.clientWidth),[s,r]=[n.clientWidth,n.clientHeight],o=34,a=62,l=v=>2*Math.ceil(.5*v),[c,u]=[l(s*i),l((r+o+a)*i)];t.width!==c&&(t.width=c),t.height!==u&&(t.height=u);let h=t.getContext("2d");h.setTransform(i,0,0,i,0,0),h.textAlign="left";let f=e.dark?"#e6e8e8":"#1e2226";h.fillStyle=e.dark?"#1c2024":"#ffffff",h.fillRect(0,0,s+2,r+o+a+2),h.drawImage(n,0,o,s,r),h.fillStyle=h.strokeStyle=f,h.font="600 15px system-ui, sans-serif",h.textBaseline="middle";let d=h.measureText(e.instant).width;h.fillText(e.title,12,o/2,Math.max(60,s-d-40)),h.textAlign="right",h.fillText(e.instant,s-12,o/2),h.textAlign="left",h.font="12px system-ui, sans-serif";for(let[v,m,p]of e.labels)m>0&&m<s&&p>0&&p<r&&h.fillText(v,m,o+p);let _=o+r+16;return h.lineWidth=1,h.beginPath(),h.moveTo(12,_-4),h.lineTo(12,_+4),h.lineTo(12+e.scale.pixels,_+4),h.lineTo(12+e.scale.pixels,_-4),h.stroke(),h.fillText(e.scale.text,20+e.scale.pixels,_),Uy(h,e,Math.max(s-320,s/2),_,Math.min(300,s/2-20)),t}function Uy(n,e,t,i,s){let r=n.fillStyle;if(e.field.kind==="names"){let o=t;for(let[a,l]of e.legend.names){if(o>t+s-40)break;n.fillStyle=Ms(l),n.fillRect(o,i-6,12,12),n.fillStyle=r,n.fillText(a,o+17,i),o+=30+n.measureText(a).width}n.fillText(e.legend.what,t,i+32);return}for(let o=0;o<128;++o)n.fillStyle=Ms(jn(e.field.kind,o/127)),n.fillRect(t+o/128*s,i-7,s/128+.6,12);n.fillStyle=r,e.legend.ticks.forEach((o,a,l)=>{n.textAlign=a===0?"left":a===l.length-1?"right":"center",n.fillText(o,t+a/(l.length-1)*s,i+15)}),n.textAlign="left",n.fillText(e.legend.what,t,i+32)}var Yg=0,Uf=1,Zg=2;var Ff=1,Jg=2,ki=3,ss=0,Nn=1,Oi=2,as=0,fr=1,Nf=2,kf=3,Of=4,Kg=5,Ls=100,jg=101,Qg=102,e0=103,t0=104,n0=200,i0=201,s0=202,r0=203,hc=204,uc=205,o0=206,a0=207,l0=208,c0=209,h0=210,u0=211,f0=212,d0=213,p0=214,Uc=0,Fc=1,Nc=2,dr=3,kc=4,Oc=5,Bc=6,zc=7,Bf=0,m0=1,g0=2,ls=0,_0=1,x0=2,v0=3,y0=4,b0=5,M0=6,w0=7;var zf=300,xr=301,vr=302,Vc=303,Hc=304,Oa=306,fc=1e3,Ps=1001,dc=1002,Gn=1003,S0=1004;var Ba=1005;var ii=1006,Gc=1007;var Ns=1008;var ri=1009,Vf=1010,Hf=1011,Mo=1012,Wc=1013,ks=1014,oi=1015,wo=1016,Xc=1017,qc=1018,So=1020,Gf=35902,Wf=1021,Xf=1022,kn=1023,po=1026,Eo=1027,qf=1028,$c=1029,$f=1030,Yc=1031;var Zc=1033,za=33776,Va=33777,Ha=33778,Ga=33779,Jc=35840,Kc=35841,jc=35842,Qc=35843,eh=36196,th=37492,nh=37496,ih=37808,sh=37809,rh=37810,oh=37811,ah=37812,lh=37813,ch=37814,hh=37815,uh=37816,fh=37817,dh=37818,ph=37819,mh=37820,gh=37821,Wa=36492,_h=36494,xh=36495,Yf=36283,vh=36284,yh=36285,bh=36286;var Ma=2300,pc=2301,cc=2302,Cf=2400,Rf=2401,If=2402;var E0=3200,T0=3201;var A0=0,C0=1,cs="",ni="srgb",pr="srgb-linear",wa="linear",Pt="srgb";var hr=7680;var Pf=519,R0=512,I0=513,P0=514,Zf=515,L0=516,D0=517,U0=518,F0=519,Lf=35044;var To="300 es",Di=2e3,Sa=2001;var rs=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},En=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var rf=Math.PI/180,mc=180/Math.PI;function Xa(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(En[n&255]+En[n>>8&255]+En[n>>16&255]+En[n>>24&255]+"-"+En[e&255]+En[e>>8&255]+"-"+En[e>>16&15|64]+En[e>>24&255]+"-"+En[t&63|128]+En[t>>8&255]+"-"+En[t>>16&255]+En[t>>24&255]+En[i&255]+En[i>>8&255]+En[i>>16&255]+En[i>>24&255]).toLowerCase()}function gt(n,e,t){return Math.max(e,Math.min(t,n))}function Fy(n,e){return(n%e+e)%e}function of(n,e,t){return(1-t)*n+t*e}function _a(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function Vn(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}var Lt=class n{constructor(e=0,t=0){n.prototype.isVector2=!0,this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(gt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(gt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},os=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],f=r[o+0],d=r[o+1],_=r[o+2],v=r[o+3];if(a===0){e[t+0]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h;return}if(a===1){e[t+0]=f,e[t+1]=d,e[t+2]=_,e[t+3]=v;return}if(h!==v||l!==f||c!==d||u!==_){let m=1-a,p=l*f+c*d+u*_+h*v,T=p>=0?1:-1,S=1-p*p;if(S>Number.EPSILON){let N=Math.sqrt(S),L=Math.atan2(N,p*T);m=Math.sin(m*L)/N,a=Math.sin(a*L)/N}let b=a*T;if(l=l*m+f*b,c=c*m+d*b,u=u*m+_*b,h=h*m+v*b,m===1-a){let N=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=N,c*=N,u*=N,h*=N}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],d=r[o+2],_=r[o+3];return e[t]=a*_+u*h+l*d-c*f,e[t+1]=l*_+u*f+c*h-a*d,e[t+2]=c*_+u*d+a*f-l*h,e[t+3]=u*_-a*h-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),d=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*_,this._y=c*d*h-f*u*_,this._z=c*u*_+f*d*h,this._w=c*u*h-f*d*_;break;case"YXZ":this._x=f*u*h+c*d*_,this._y=c*d*h-f*u*_,this._z=c*u*_-f*d*h,this._w=c*u*h+f*d*_;break;case"ZXY":this._x=f*u*h-c*d*_,this._y=c*d*h+f*u*_,this._z=c*u*_+f*d*h,this._w=c*u*h-f*d*_;break;case"ZYX":this._x=f*u*h-c*d*_,this._y=c*d*h+f*u*_,this._z=c*u*_-f*d*h,this._w=c*u*h+f*d*_;break;case"YZX":this._x=f*u*h+c*d*_,this._y=c*d*h+f*u*_,this._z=c*u*_-f*d*h,this._w=c*u*h-f*d*_;break;case"XZY":this._x=f*u*h-c*d*_,this._y=c*d*h-f*u*_,this._z=c*u*_+f*d*h,this._w=c*u*h+f*d*_;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=i+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>h){let d=2*Math.sqrt(1+i-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-i-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(gt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){if(t===0)return this;if(t===1)return this.copy(e);let i=this._x,s=this._y,r=this._z,o=this._w,a=o*e._w+i*e._x+s*e._y+r*e._z;if(a<0?(this._w=-e._w,this._x=-e._x,this._y=-e._y,this._z=-e._z,a=-a):this.copy(e),a>=1)return this._w=o,this._x=i,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let d=1-t;return this._w=d*o+t*this._w,this._x=d*i+t*this._x,this._y=d*s+t*this._y,this._z=d*r+t*this._z,this.normalize(),this}let c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-t)*u)/c,f=Math.sin(t*u)/c;return this._w=o*h+this._w*f,this._x=i*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},K=class n{constructor(e=0,t=0,i=0){n.prototype.isVector3=!0,this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Pg.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Pg.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(gt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return af.copy(this).projectOnVector(e),this.sub(af)}reflect(e){return this.sub(af.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(gt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},af=new K,Pg=new os,ot=class n{constructor(e,t,i,s,r,o,a,l,c){n.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],d=i[5],_=i[8],v=s[0],m=s[3],p=s[6],T=s[1],S=s[4],b=s[7],N=s[2],L=s[5],D=s[8];return r[0]=o*v+a*T+l*N,r[3]=o*m+a*S+l*L,r[6]=o*p+a*b+l*D,r[1]=c*v+u*T+h*N,r[4]=c*m+u*S+h*L,r[7]=c*p+u*b+h*D,r[2]=f*v+d*T+_*N,r[5]=f*m+d*S+_*L,r[8]=f*p+d*b+_*D,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,_=t*h+i*f+s*d;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/_;return e[0]=h*v,e[1]=(s*c-u*i)*v,e[2]=(a*i-s*o)*v,e[3]=f*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=d*v,e[7]=(i*l-c*t)*v,e[8]=(o*t-i*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return this.premultiply(lf.makeScale(e,t)),this}rotate(e){return this.premultiply(lf.makeRotation(-e)),this}translate(e,t){return this.premultiply(lf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},lf=new ot;function Jf(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function Ea(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function N0(){let n=Ea("canvas");return n.style.display="block",n}var Lg={};function mr(n){n in Lg||(Lg[n]=!0,console.warn(n))}function k0(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}function O0(n){let e=n.elements;e[2]=.5*e[2]+.5*e[3],e[6]=.5*e[6]+.5*e[7],e[10]=.5*e[10]+.5*e[11],e[14]=.5*e[14]+.5*e[15]}function B0(n){let e=n.elements;e[11]===-1?(e[10]=-e[10]-1,e[14]=-e[14]):(e[10]=-e[10],e[14]=-e[14]+1)}var Dg=new ot().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Ug=new ot().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Ny(){let n={enabled:!0,workingColorSpace:pr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=is(s.r),s.g=is(s.g),s.b=is(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=fo(s.r),s.g=fo(s.g),s.b=fo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===cs?wa:this.spaces[s].transfer},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return mr("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),n.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return mr("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),n.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[pr]:{primaries:e,whitePoint:i,transfer:wa,toXYZ:Dg,fromXYZ:Ug,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:ni},outputColorSpaceConfig:{drawingBufferColorSpace:ni}},[ni]:{primaries:e,whitePoint:i,transfer:Pt,toXYZ:Dg,fromXYZ:Ug,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:ni}}}),n}var mt=Ny();function is(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function fo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var eo,gc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{eo===void 0&&(eo=Ea("canvas")),eo.width=e.width,eo.height=e.height;let s=eo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=eo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ea("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=is(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(is(t[i]/255)*255):t[i]=is(t[i]);return{data:t,width:e.width,height:e.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},ky=0,mo=class{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:ky++}),this.uuid=Xa(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(cf(s[o].image)):r.push(cf(s[o]))}else r=cf(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function cf(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?gc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var Oy=0,hf=new K,Wn=class n extends rs{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Ps,s=Ps,r=ii,o=Ns,a=kn,l=ri,c=n.DEFAULT_ANISOTROPY,u=cs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Oy++}),this.uuid=Xa(),this.name="",this.source=new mo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Lt(0,0),this.repeat=new Lt(1,1),this.center=new Lt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ot,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(hf).x}get height(){return this.source.getSize(hf).y}get depth(){return this.source.getSize(hf).z}get image(){return this.source.data}set image(e=null){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){console.warn(`THREE.Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==zf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case fc:e.x=e.x-Math.floor(e.x);break;case Ps:e.x=e.x<0?0:1;break;case dc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case fc:e.y=e.y-Math.floor(e.y);break;case Ps:e.y=e.y<0?0:1;break;case dc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Wn.DEFAULT_IMAGE=null;Wn.DEFAULT_MAPPING=zf;Wn.DEFAULT_ANISOTROPY=1;var Yt=class n{constructor(e=0,t=0,i=0,s=1){n.prototype.isVector4=!0,this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],_=l[9],v=l[2],m=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(_-m)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(_+m)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let S=(c+1)/2,b=(d+1)/2,N=(p+1)/2,L=(u+f)/4,D=(h+v)/4,B=(_+m)/4;return S>b&&S>N?S<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(S),s=L/i,r=D/i):b>N?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=L/s,r=B/s):N<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(N),i=D/r,s=B/r),this.set(i,s,r,t),this}let T=Math.sqrt((m-_)*(m-_)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(T)<.001&&(T=1),this.x=(m-_)/T,this.y=(h-v)/T,this.z=(f-u)/T,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=gt(this.x,e.x,t.x),this.y=gt(this.y,e.y,t.y),this.z=gt(this.z,e.z,t.z),this.w=gt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=gt(this.x,e,t),this.y=gt(this.y,e,t),this.z=gt(this.z,e,t),this.w=gt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(gt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},_c=class extends rs{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ii,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Yt(0,0,e,t),this.scissorTest=!1,this.viewport=new Yt(0,0,e,t);let s={width:e,height:t,depth:i.depth},r=new Wn(s);this.textures=[];let o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview}_setTextureOptions(e={}){let t={minFilter:ii,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new mo(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Fi=class extends _c{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Ta=class extends Wn{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Gn,this.minFilter=Gn,this.wrapR=Ps,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var xc=class extends Wn{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Gn,this.minFilter=Gn,this.wrapR=Ps,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ds=class{constructor(e=new K(1/0,1/0,1/0),t=new K(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(bi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(bi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=bi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,bi):bi.fromBufferAttribute(r,o),bi.applyMatrix4(e.matrixWorld),this.expandByPoint(bi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Xl.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Xl.copy(i.boundingBox)),Xl.applyMatrix4(e.matrixWorld),this.union(Xl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,bi),bi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(xa),ql.subVectors(this.max,xa),to.subVectors(e.a,xa),no.subVectors(e.b,xa),io.subVectors(e.c,xa),Ss.subVectors(no,to),Es.subVectors(io,no),or.subVectors(to,io);let t=[0,-Ss.z,Ss.y,0,-Es.z,Es.y,0,-or.z,or.y,Ss.z,0,-Ss.x,Es.z,0,-Es.x,or.z,0,-or.x,-Ss.y,Ss.x,0,-Es.y,Es.x,0,-or.y,or.x,0];return!uf(t,to,no,io,ql)||(t=[1,0,0,0,1,0,0,0,1],!uf(t,to,no,io,ql))?!1:($l.crossVectors(Ss,Es),t=[$l.x,$l.y,$l.z],uf(t,to,no,io,ql))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,bi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(bi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ji[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ji[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ji[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ji[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ji[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ji[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ji[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ji[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ji),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ji=[new K,new K,new K,new K,new K,new K,new K,new K],bi=new K,Xl=new Ds,to=new K,no=new K,io=new K,Ss=new K,Es=new K,or=new K,xa=new K,ql=new K,$l=new K,ar=new K;function uf(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){ar.fromArray(n,r);let a=s.x*Math.abs(ar.x)+s.y*Math.abs(ar.y)+s.z*Math.abs(ar.z),l=e.dot(ar),c=t.dot(ar),u=i.dot(ar);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var By=new Ds,va=new K,ff=new K,go=class{constructor(e=new K,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):By.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;va.subVectors(e,this.center);let t=va.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(va,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ff.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(va.copy(e.center).add(ff)),this.expandByPoint(va.copy(e.center).sub(ff))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Qi=new K,df=new K,Yl=new K,Ts=new K,pf=new K,Zl=new K,mf=new K,vc=class{constructor(e=new K,t=new K(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Qi)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Qi.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Qi.copy(this.origin).addScaledVector(this.direction,t),Qi.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){df.copy(e).add(t).multiplyScalar(.5),Yl.copy(t).sub(e).normalize(),Ts.copy(this.origin).sub(df);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Yl),a=Ts.dot(this.direction),l=-Ts.dot(Yl),c=Ts.lengthSq(),u=Math.abs(1-o*o),h,f,d,_;if(u>0)if(h=o*l-a,f=o*a-l,_=r*u,h>=0)if(f>=-_)if(f<=_){let v=1/u;h*=v,f*=v,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-_?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=_?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(df).addScaledVector(Yl,f),d}intersectSphere(e,t){Qi.subVectors(e.center,this.origin);let i=Qi.dot(this.direction),s=Qi.dot(Qi)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Qi)!==null}intersectTriangle(e,t,i,s,r){pf.subVectors(t,e),Zl.subVectors(i,e),mf.crossVectors(pf,Zl);let o=this.direction.dot(mf),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;Ts.subVectors(this.origin,e);let l=a*this.direction.dot(Zl.crossVectors(Ts,Zl));if(l<0)return null;let c=a*this.direction.dot(pf.cross(Ts));if(c<0||l+c>o)return null;let u=-a*Ts.dot(mf);return u<0?null:this.at(u/o,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},on=class n{constructor(e,t,i,s,r,o,a,l,c,u,h,f,d,_,v,m){n.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,f,d,_,v,m)}set(e,t,i,s,r,o,a,l,c,u,h,f,d,_,v,m){let p=this.elements;return p[0]=e,p[4]=t,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=_,p[11]=v,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){let t=this.elements,i=e.elements,s=1/so.setFromMatrixColumn(e,0).length(),r=1/so.setFromMatrixColumn(e,1).length(),o=1/so.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,d=o*h,_=a*u,v=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=d+_*c,t[5]=f-v*c,t[9]=-a*l,t[2]=v-f*c,t[6]=_+d*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,d=l*h,_=c*u,v=c*h;t[0]=f+v*a,t[4]=_*a-d,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=d*a-_,t[6]=v+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,d=l*h,_=c*u,v=c*h;t[0]=f-v*a,t[4]=-o*h,t[8]=_+d*a,t[1]=d+_*a,t[5]=o*u,t[9]=v-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,d=o*h,_=a*u,v=a*h;t[0]=l*u,t[4]=_*c-d,t[8]=f*c+v,t[1]=l*h,t[5]=v*c+f,t[9]=d*c-_,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,d=o*c,_=a*l,v=a*c;t[0]=l*u,t[4]=v-f*h,t[8]=_*h+d,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*h+_,t[10]=f-v*h}else if(e.order==="XZY"){let f=o*l,d=o*c,_=a*l,v=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+v,t[5]=o*u,t[9]=d*h-_,t[2]=_*h-d,t[6]=a*u,t[10]=v*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(zy,e,Vy)}lookAt(e,t,i){let s=this.elements;return ei.subVectors(e,t),ei.lengthSq()===0&&(ei.z=1),ei.normalize(),As.crossVectors(i,ei),As.lengthSq()===0&&(Math.abs(i.z)===1?ei.x+=1e-4:ei.z+=1e-4,ei.normalize(),As.crossVectors(i,ei)),As.normalize(),Jl.crossVectors(ei,As),s[0]=As.x,s[4]=Jl.x,s[8]=ei.x,s[1]=As.y,s[5]=Jl.y,s[9]=ei.y,s[2]=As.z,s[6]=Jl.z,s[10]=ei.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],d=i[13],_=i[2],v=i[6],m=i[10],p=i[14],T=i[3],S=i[7],b=i[11],N=i[15],L=s[0],D=s[4],B=s[8],E=s[12],M=s[1],I=s[5],q=s[9],z=s[13],W=s[2],Y=s[6],$=s[10],j=s[14],Q=s[3],he=s[7],ce=s[11],_e=s[15];return r[0]=o*L+a*M+l*W+c*Q,r[4]=o*D+a*I+l*Y+c*he,r[8]=o*B+a*q+l*$+c*ce,r[12]=o*E+a*z+l*j+c*_e,r[1]=u*L+h*M+f*W+d*Q,r[5]=u*D+h*I+f*Y+d*he,r[9]=u*B+h*q+f*$+d*ce,r[13]=u*E+h*z+f*j+d*_e,r[2]=_*L+v*M+m*W+p*Q,r[6]=_*D+v*I+m*Y+p*he,r[10]=_*B+v*q+m*$+p*ce,r[14]=_*E+v*z+m*j+p*_e,r[3]=T*L+S*M+b*W+N*Q,r[7]=T*D+S*I+b*Y+N*he,r[11]=T*B+S*q+b*$+N*ce,r[15]=T*E+S*z+b*j+N*_e,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],d=e[14],_=e[3],v=e[7],m=e[11],p=e[15];return _*(+r*l*h-s*c*h-r*a*f+i*c*f+s*a*d-i*l*d)+v*(+t*l*d-t*c*f+r*o*f-s*o*d+s*c*u-r*l*u)+m*(+t*c*h-t*a*d-r*o*h+i*o*d+r*a*u-i*c*u)+p*(-s*a*u-t*l*h+t*a*f+s*o*h-i*o*f+i*l*u)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],d=e[11],_=e[12],v=e[13],m=e[14],p=e[15],T=h*m*c-v*f*c+v*l*d-a*m*d-h*l*p+a*f*p,S=_*f*c-u*m*c-_*l*d+o*m*d+u*l*p-o*f*p,b=u*v*c-_*h*c+_*a*d-o*v*d-u*a*p+o*h*p,N=_*h*l-u*v*l-_*a*f+o*v*f+u*a*m-o*h*m,L=t*T+i*S+s*b+r*N;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let D=1/L;return e[0]=T*D,e[1]=(v*f*r-h*m*r-v*s*d+i*m*d+h*s*p-i*f*p)*D,e[2]=(a*m*r-v*l*r+v*s*c-i*m*c-a*s*p+i*l*p)*D,e[3]=(h*l*r-a*f*r-h*s*c+i*f*c+a*s*d-i*l*d)*D,e[4]=S*D,e[5]=(u*m*r-_*f*r+_*s*d-t*m*d-u*s*p+t*f*p)*D,e[6]=(_*l*r-o*m*r-_*s*c+t*m*c+o*s*p-t*l*p)*D,e[7]=(o*f*r-u*l*r+u*s*c-t*f*c-o*s*d+t*l*d)*D,e[8]=b*D,e[9]=(_*h*r-u*v*r-_*i*d+t*v*d+u*i*p-t*h*p)*D,e[10]=(o*v*r-_*a*r+_*i*c-t*v*c-o*i*p+t*a*p)*D,e[11]=(u*a*r-o*h*r-u*i*c+t*h*c+o*i*d-t*a*d)*D,e[12]=N*D,e[13]=(u*v*s-_*h*s+_*i*f-t*v*f-u*i*m+t*h*m)*D,e[14]=(_*a*s-o*v*s-_*i*l+t*v*l+o*i*m-t*a*m)*D,e[15]=(o*h*s-u*a*s+u*i*l-t*h*l-o*i*f+t*a*f)*D,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,_=r*h,v=o*u,m=o*h,p=a*h,T=l*c,S=l*u,b=l*h,N=i.x,L=i.y,D=i.z;return s[0]=(1-(v+p))*N,s[1]=(d+b)*N,s[2]=(_-S)*N,s[3]=0,s[4]=(d-b)*L,s[5]=(1-(f+p))*L,s[6]=(m+T)*L,s[7]=0,s[8]=(_+S)*D,s[9]=(m-T)*D,s[10]=(1-(f+v))*D,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements,r=so.set(s[0],s[1],s[2]).length(),o=so.set(s[4],s[5],s[6]).length(),a=so.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),e.x=s[12],e.y=s[13],e.z=s[14],Mi.copy(this);let c=1/r,u=1/o,h=1/a;return Mi.elements[0]*=c,Mi.elements[1]*=c,Mi.elements[2]*=c,Mi.elements[4]*=u,Mi.elements[5]*=u,Mi.elements[6]*=u,Mi.elements[8]*=h,Mi.elements[9]*=h,Mi.elements[10]*=h,t.setFromRotationMatrix(Mi),i.x=r,i.y=o,i.z=a,this}makePerspective(e,t,i,s,r,o,a=Di){let l=this.elements,c=2*r/(t-e),u=2*r/(i-s),h=(t+e)/(t-e),f=(i+s)/(i-s),d,_;if(a===Di)d=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===Sa)d=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=h,l[12]=0,l[1]=0,l[5]=u,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=d,l[14]=_,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Di){let l=this.elements,c=1/(t-e),u=1/(i-s),h=1/(o-r),f=(t+e)*c,d=(i+s)*u,_,v;if(a===Di)_=(o+r)*h,v=-2*h;else if(a===Sa)_=r*h,v=-1*h;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-f,l[1]=0,l[5]=2*u,l[9]=0,l[13]=-d,l[2]=0,l[6]=0,l[10]=v,l[14]=-_,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},so=new K,Mi=new on,zy=new K(0,0,0),Vy=new K(1,1,1),As=new K,Jl=new K,ei=new K,Fg=new on,Ng=new os,Ni=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(gt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-gt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(gt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-gt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(gt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-gt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Fg.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Fg,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Ng.setFromEuler(this),this.setFromQuaternion(Ng,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ni.DEFAULT_ORDER="XYZ";var Aa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Hy=0,kg=new K,ro=new os,es=new on,Kl=new K,ya=new K,Gy=new K,Wy=new os,Og=new K(1,0,0),Bg=new K(0,1,0),zg=new K(0,0,1),Vg={type:"added"},Xy={type:"removed"},oo={type:"childadded",child:null},gf={type:"childremoved",child:null},di=class n extends rs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Hy++}),this.uuid=Xa(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new K,t=new Ni,i=new os,s=new K(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new on},normalMatrix:{value:new ot}}),this.matrix=new on,this.matrixWorld=new on,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Aa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return ro.setFromAxisAngle(e,t),this.quaternion.multiply(ro),this}rotateOnWorldAxis(e,t){return ro.setFromAxisAngle(e,t),this.quaternion.premultiply(ro),this}rotateX(e){return this.rotateOnAxis(Og,e)}rotateY(e){return this.rotateOnAxis(Bg,e)}rotateZ(e){return this.rotateOnAxis(zg,e)}translateOnAxis(e,t){return kg.copy(e).applyQuaternion(this.quaternion),this.position.add(kg.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Og,e)}translateY(e){return this.translateOnAxis(Bg,e)}translateZ(e){return this.translateOnAxis(zg,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(es.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Kl.copy(e):Kl.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ya.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?es.lookAt(ya,Kl,this.up):es.lookAt(Kl,ya,this.up),this.quaternion.setFromRotationMatrix(es),s&&(es.extractRotation(s.matrixWorld),ro.setFromRotationMatrix(es),this.quaternion.premultiply(ro.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Vg),oo.child=e,this.dispatchEvent(oo),oo.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Xy),gf.child=e,this.dispatchEvent(gf),gf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),es.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),es.multiply(e.parent.matrixWorld)),e.applyMatrix4(es),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Vg),oo.child=e,this.dispatchEvent(oo),oo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ya,e,Gy),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ya,Wy,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t){let i=this.parent;if(e===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),d=o(e.animations),_=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),_.length>0&&(i.nodes=_)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}};di.DEFAULT_UP=new K(0,1,0);di.DEFAULT_MATRIX_AUTO_UPDATE=!0;di.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var wi=new K,ts=new K,_f=new K,ns=new K,ao=new K,lo=new K,Hg=new K,xf=new K,vf=new K,yf=new K,bf=new Yt,Mf=new Yt,wf=new Yt,Is=class n{constructor(e=new K,t=new K,i=new K){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),wi.subVectors(e,t),s.cross(wi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){wi.subVectors(s,t),ts.subVectors(i,t),_f.subVectors(e,t);let o=wi.dot(wi),a=wi.dot(ts),l=wi.dot(_f),c=ts.dot(ts),u=ts.dot(_f),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,_=(o*u-a*l)*f;return r.set(1-d-_,_,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,ns)===null?!1:ns.x>=0&&ns.y>=0&&ns.x+ns.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,ns)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ns.x),l.addScaledVector(o,ns.y),l.addScaledVector(a,ns.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return bf.setScalar(0),Mf.setScalar(0),wf.setScalar(0),bf.fromBufferAttribute(e,t),Mf.fromBufferAttribute(e,i),wf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(bf,r.x),o.addScaledVector(Mf,r.y),o.addScaledVector(wf,r.z),o}static isFrontFacing(e,t,i,s){return wi.subVectors(i,t),ts.subVectors(e,t),wi.cross(ts).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return wi.subVectors(this.c,this.b),ts.subVectors(this.a,this.b),wi.cross(ts).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;ao.subVectors(s,i),lo.subVectors(r,i),xf.subVectors(e,i);let l=ao.dot(xf),c=lo.dot(xf);if(l<=0&&c<=0)return t.copy(i);vf.subVectors(e,s);let u=ao.dot(vf),h=lo.dot(vf);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),t.copy(i).addScaledVector(ao,o);yf.subVectors(e,r);let d=ao.dot(yf),_=lo.dot(yf);if(_>=0&&d<=_)return t.copy(r);let v=d*c-l*_;if(v<=0&&c>=0&&_<=0)return a=c/(c-_),t.copy(i).addScaledVector(lo,a);let m=u*_-d*h;if(m<=0&&h-u>=0&&d-_>=0)return Hg.subVectors(r,s),a=(h-u)/(h-u+(d-_)),t.copy(s).addScaledVector(Hg,a);let p=1/(m+v+f);return o=v*p,a=f*p,t.copy(i).addScaledVector(ao,o).addScaledVector(lo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},z0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Cs={h:0,s:0,l:0},jl={h:0,s:0,l:0};function Sf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var At=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ni){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,mt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=mt.workingColorSpace){return this.r=e,this.g=t,this.b=i,mt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=mt.workingColorSpace){if(e=Fy(e,1),t=gt(t,0,1),i=gt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Sf(o,r,e+1/3),this.g=Sf(o,r,e),this.b=Sf(o,r,e-1/3)}return mt.colorSpaceToWorking(this,s),this}setStyle(e,t=ni){function i(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:console.warn("THREE.Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);console.warn("THREE.Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ni){let i=z0[e.toLowerCase()];return i!==void 0?this.setHex(i,t):console.warn("THREE.Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=is(e.r),this.g=is(e.g),this.b=is(e.b),this}copyLinearToSRGB(e){return this.r=fo(e.r),this.g=fo(e.g),this.b=fo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ni){return mt.workingToColorSpace(Tn.copy(this),e),Math.round(gt(Tn.r*255,0,255))*65536+Math.round(gt(Tn.g*255,0,255))*256+Math.round(gt(Tn.b*255,0,255))}getHexString(e=ni){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=mt.workingColorSpace){mt.workingToColorSpace(Tn.copy(this),t);let i=Tn.r,s=Tn.g,r=Tn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=mt.workingColorSpace){return mt.workingToColorSpace(Tn.copy(this),t),e.r=Tn.r,e.g=Tn.g,e.b=Tn.b,e}getStyle(e=ni){mt.workingToColorSpace(Tn.copy(this),e);let t=Tn.r,i=Tn.g,s=Tn.b;return e!==ni?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Cs),this.setHSL(Cs.h+e,Cs.s+t,Cs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Cs),e.getHSL(jl);let i=of(Cs.h,jl.h,t),s=of(Cs.s,jl.s,t),r=of(Cs.l,jl.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Tn=new At;At.NAMES=z0;var qy=0,gr=class extends rs{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:qy++}),this.uuid=Xa(),this.name="",this.type="Material",this.blending=fr,this.side=ss,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=hc,this.blendDst=uc,this.blendEquation=Ls,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new At(0,0,0),this.blendAlpha=0,this.depthFunc=dr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Pf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=hr,this.stencilZFail=hr,this.stencilZPass=hr,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){console.warn(`THREE.Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){console.warn(`THREE.Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==fr&&(i.blending=this.blending),this.side!==ss&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==hc&&(i.blendSrc=this.blendSrc),this.blendDst!==uc&&(i.blendDst=this.blendDst),this.blendEquation!==Ls&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==dr&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==Pf&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==hr&&(i.stencilFail=this.stencilFail),this.stencilZFail!==hr&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==hr&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}},Ca=class extends gr{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new At(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ni,this.combine=Bf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}};var rn=new K,Ql=new Lt,$y=0,dn=class{constructor(e,t,i=!1){if(Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:$y++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Lf,this.updateRanges=[],this.gpuType=oi,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Ql.fromBufferAttribute(this,t),Ql.applyMatrix3(e),this.setXY(t,Ql.x,Ql.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)rn.fromBufferAttribute(this,t),rn.applyMatrix3(e),this.setXYZ(t,rn.x,rn.y,rn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)rn.fromBufferAttribute(this,t),rn.applyMatrix4(e),this.setXYZ(t,rn.x,rn.y,rn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)rn.fromBufferAttribute(this,t),rn.applyNormalMatrix(e),this.setXYZ(t,rn.x,rn.y,rn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)rn.fromBufferAttribute(this,t),rn.transformDirection(e),this.setXYZ(t,rn.x,rn.y,rn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=_a(i,this.array)),i}setComponent(e,t,i){return this.normalized&&(i=Vn(i,this.array)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=_a(t,this.array)),t}setX(e,t){return this.normalized&&(t=Vn(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=_a(t,this.array)),t}setY(e,t){return this.normalized&&(t=Vn(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=_a(t,this.array)),t}setZ(e,t){return this.normalized&&(t=Vn(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=_a(t,this.array)),t}setW(e,t){return this.normalized&&(t=Vn(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=Vn(t,this.array),i=Vn(i,this.array)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=Vn(t,this.array),i=Vn(i,this.array),s=Vn(s,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=Vn(t,this.array),i=Vn(i,this.array),s=Vn(s,this.array),r=Vn(r,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==Lf&&(e.usage=this.usage),e}};var Ra=class extends dn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Ia=class extends dn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Ui=class extends dn{constructor(e,t,i){super(new Float32Array(e),t,i)}},Yy=0,fi=new on,Ef=new di,co=new K,ti=new Ds,ba=new Ds,bn=new K,pi=class n extends rs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Yy++}),this.uuid=Xa(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Jf(e)?Ia:Ra)(e,1):this.index=e,this}setIndirect(e){return this.indirect=e,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ot().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return fi.makeRotationFromQuaternion(e),this.applyMatrix4(fi),this}rotateX(e){return fi.makeRotationX(e),this.applyMatrix4(fi),this}rotateY(e){return fi.makeRotationY(e),this.applyMatrix4(fi),this}rotateZ(e){return fi.makeRotationZ(e),this.applyMatrix4(fi),this}translate(e,t,i){return fi.makeTranslation(e,t,i),this.applyMatrix4(fi),this}scale(e,t,i){return fi.makeScale(e,t,i),this.applyMatrix4(fi),this}lookAt(e){return Ef.lookAt(e),Ef.updateMatrix(),this.applyMatrix4(Ef.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(co).negate(),this.translate(co.x,co.y,co.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Ui(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ds);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new K(-1/0,-1/0,-1/0),new K(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];ti.setFromBufferAttribute(r),this.morphTargetsRelative?(bn.addVectors(this.boundingBox.min,ti.min),this.boundingBox.expandByPoint(bn),bn.addVectors(this.boundingBox.max,ti.max),this.boundingBox.expandByPoint(bn)):(this.boundingBox.expandByPoint(ti.min),this.boundingBox.expandByPoint(ti.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new go);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new K,1/0);return}if(e){let i=this.boundingSphere.center;if(ti.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ba.setFromBufferAttribute(a),this.morphTargetsRelative?(bn.addVectors(ti.min,ba.min),ti.expandByPoint(bn),bn.addVectors(ti.max,ba.max),ti.expandByPoint(bn)):(ti.expandByPoint(ba.min),ti.expandByPoint(ba.max))}ti.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)bn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(bn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)bn.fromBufferAttribute(a,c),l&&(co.fromBufferAttribute(e,c),bn.add(co)),s=Math.max(s,i.distanceToSquared(bn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new dn(new Float32Array(4*i.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let B=0;B<i.count;B++)a[B]=new K,l[B]=new K;let c=new K,u=new K,h=new K,f=new Lt,d=new Lt,_=new Lt,v=new K,m=new K;function p(B,E,M){c.fromBufferAttribute(i,B),u.fromBufferAttribute(i,E),h.fromBufferAttribute(i,M),f.fromBufferAttribute(r,B),d.fromBufferAttribute(r,E),_.fromBufferAttribute(r,M),u.sub(c),h.sub(c),d.sub(f),_.sub(f);let I=1/(d.x*_.y-_.x*d.y);isFinite(I)&&(v.copy(u).multiplyScalar(_.y).addScaledVector(h,-d.y).multiplyScalar(I),m.copy(h).multiplyScalar(d.x).addScaledVector(u,-_.x).multiplyScalar(I),a[B].add(v),a[E].add(v),a[M].add(v),l[B].add(m),l[E].add(m),l[M].add(m))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let B=0,E=T.length;B<E;++B){let M=T[B],I=M.start,q=M.count;for(let z=I,W=I+q;z<W;z+=3)p(e.getX(z+0),e.getX(z+1),e.getX(z+2))}let S=new K,b=new K,N=new K,L=new K;function D(B){N.fromBufferAttribute(s,B),L.copy(N);let E=a[B];S.copy(E),S.sub(N.multiplyScalar(N.dot(E))).normalize(),b.crossVectors(L,E);let I=b.dot(l[B])<0?-1:1;o.setXYZW(B,S.x,S.y,S.z,I)}for(let B=0,E=T.length;B<E;++B){let M=T[B],I=M.start,q=M.count;for(let z=I,W=I+q;z<W;z+=3)D(e.getX(z+0)),D(e.getX(z+1)),D(e.getX(z+2))}}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new dn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);let s=new K,r=new K,o=new K,a=new K,l=new K,c=new K,u=new K,h=new K;if(e)for(let f=0,d=e.count;f<d;f+=3){let _=e.getX(f+0),v=e.getX(f+1),m=e.getX(f+2);s.fromBufferAttribute(t,_),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,_),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(_,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=t.count;f<d;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)bn.fromBufferAttribute(e,t),bn.normalize(),e.setXYZ(t,bn.x,bn.y,bn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,_=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?d=l[v]*a.data.stride+a.offset:d=l[v]*u;for(let p=0;p<u;p++)f[_++]=c[d++]}return new dn(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=e(f,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},Gg=new on,lr=new vc,ec=new go,Wg=new K,tc=new K,nc=new K,ic=new K,Tf=new K,sc=new K,Xg=new K,rc=new K,Fn=class extends di{constructor(e=new pi,t=new Ca){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){sc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Tf.fromBufferAttribute(h,e),o?sc.addScaledVector(Tf,u):sc.addScaledVector(Tf.sub(t),u))}t.add(sc)}return t}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),ec.copy(i.boundingSphere),ec.applyMatrix4(r),lr.copy(e.ray).recast(e.near),!(ec.containsPoint(lr.origin)===!1&&(lr.intersectSphere(ec,Wg)===null||lr.origin.distanceToSquared(Wg)>(e.far-e.near)**2))&&(Gg.copy(r).invert(),lr.copy(e.ray).applyMatrix4(Gg),!(i.boundingBox!==null&&lr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,lr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,v=f.length;_<v;_++){let m=f[_],p=o[m.materialIndex],T=Math.max(m.start,d.start),S=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let b=T,N=S;b<N;b+=3){let L=a.getX(b),D=a.getX(b+1),B=a.getX(b+2);s=oc(this,p,e,i,c,u,h,L,D,B),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let _=Math.max(0,d.start),v=Math.min(a.count,d.start+d.count);for(let m=_,p=v;m<p;m+=3){let T=a.getX(m),S=a.getX(m+1),b=a.getX(m+2);s=oc(this,o,e,i,c,u,h,T,S,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,v=f.length;_<v;_++){let m=f[_],p=o[m.materialIndex],T=Math.max(m.start,d.start),S=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let b=T,N=S;b<N;b+=3){let L=b,D=b+1,B=b+2;s=oc(this,p,e,i,c,u,h,L,D,B),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let _=Math.max(0,d.start),v=Math.min(l.count,d.start+d.count);for(let m=_,p=v;m<p;m+=3){let T=m,S=m+1,b=m+2;s=oc(this,o,e,i,c,u,h,T,S,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function Zy(n,e,t,i,s,r,o,a){let l;if(e.side===Nn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===ss,a),l===null)return null;rc.copy(a),rc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(rc);return c<t.near||c>t.far?null:{distance:c,point:rc.clone(),object:n}}function oc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,tc),n.getVertexPosition(l,nc),n.getVertexPosition(c,ic);let u=Zy(n,e,t,i,tc,nc,ic,Xg);if(u){let h=new K;Is.getBarycoord(Xg,tc,nc,ic,h),s&&(u.uv=Is.getInterpolatedAttribute(s,a,l,c,h,new Lt)),r&&(u.uv1=Is.getInterpolatedAttribute(r,a,l,c,h,new Lt)),o&&(u.normal=Is.getInterpolatedAttribute(o,a,l,c,h,new K),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new K,materialIndex:0};Is.getNormal(tc,nc,ic,f.normal),u.face=f,u.barycoord=h}return u}var _o=class n extends pi{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;_("z","y","x",-1,-1,i,t,e,o,r,0),_("z","y","x",1,-1,i,t,-e,o,r,1),_("x","z","y",1,1,e,i,t,s,o,2),_("x","z","y",1,-1,e,i,-t,s,o,3),_("x","y","z",1,-1,e,t,i,s,r,4),_("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Ui(c,3)),this.setAttribute("normal",new Ui(u,3)),this.setAttribute("uv",new Ui(h,2));function _(v,m,p,T,S,b,N,L,D,B,E){let M=b/D,I=N/B,q=b/2,z=N/2,W=L/2,Y=D+1,$=B+1,j=0,Q=0,he=new K;for(let ce=0;ce<$;ce++){let _e=ce*I-z;for(let Se=0;Se<Y;Se++){let me=Se*M-q;he[v]=me*T,he[m]=_e*S,he[p]=W,c.push(he.x,he.y,he.z),he[v]=0,he[m]=0,he[p]=L>0?1:-1,u.push(he.x,he.y,he.z),h.push(Se/D),h.push(1-ce/B),j+=1}}for(let ce=0;ce<B;ce++)for(let _e=0;_e<D;_e++){let Se=f+_e+Y*ce,me=f+_e+Y*(ce+1),ee=f+(_e+1)+Y*(ce+1),ue=f+(_e+1)+Y*ce;l.push(Se,me,ue),l.push(me,ee,ue),Q+=6}a.addGroup(d,Q,E),d+=Q,f+=j}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};function yr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone():Array.isArray(s)?e[t][i]=s.slice():e[t][i]=s}}return e}function An(n){let e={};for(let t=0;t<n.length;t++){let i=yr(n[t]);for(let s in i)e[s]=i[s]}return e}function Jy(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Kf(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:mt.workingColorSpace}var V0={clone:yr,merge:An},Ky=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,jy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,mi=class extends gr{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Ky,this.fragmentShader=jy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=yr(e.uniforms),this.uniformsGroups=Jy(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}},Pa=class extends di{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new on,this.projectionMatrix=new on,this.projectionMatrixInverse=new on,this.coordinateSystem=Di}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},Rs=new K,qg=new Lt,$g=new Lt,Hn=class extends Pa{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=mc*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(rf*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return mc*2*Math.atan(Math.tan(rf*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Rs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Rs.x,Rs.y).multiplyScalar(-e/Rs.z),Rs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Rs.x,Rs.y).multiplyScalar(-e/Rs.z)}getViewSize(e,t){return this.getViewBounds(e,qg,$g),t.subVectors($g,qg)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(rf*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},ho=-90,uo=1,yc=class extends di{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Hn(ho,uo,e,t);s.layers=this.layers,this.add(s);let r=new Hn(ho,uo,e,t);r.layers=this.layers,this.add(r);let o=new Hn(ho,uo,e,t);o.layers=this.layers,this.add(o);let a=new Hn(ho,uo,e,t);a.layers=this.layers,this.add(a);let l=new Hn(ho,uo,e,t);l.layers=this.layers,this.add(l);let c=new Hn(ho,uo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Di)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Sa)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;let v=i.texture.generateMipmaps;i.texture.generateMipmaps=!1,e.setRenderTarget(i,0,s),e.render(t,r),e.setRenderTarget(i,1,s),e.render(t,o),e.setRenderTarget(i,2,s),e.render(t,a),e.setRenderTarget(i,3,s),e.render(t,l),e.setRenderTarget(i,4,s),e.render(t,c),i.texture.generateMipmaps=v,e.setRenderTarget(i,5,s),e.render(t,u),e.setRenderTarget(h,f,d),e.xr.enabled=_,i.texture.needsPMREMUpdate=!0}},La=class extends Wn{constructor(e=[],t=xr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},bc=class extends Fi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new La(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new _o(5,5,5),r=new mi({name:"CubemapFromEquirect",uniforms:yr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Nn,blending:as});r.uniforms.tEquirect.value=t;let o=new Fn(s,r),a=t.minFilter;return t.minFilter===Ns&&(t.minFilter=ii),new yc(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},ur=class extends di{constructor(){super(),this.isGroup=!0,this.type="Group"}},Qy={type:"move"},xo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ur,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ur,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new K,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new K),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ur,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new K,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new K),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let m=t.getJointPose(v,i),p=this._getHandJoint(c,v);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,_=.005;c.inputState.pinching&&f>d+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Qy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new ur;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}};var Da=class extends di{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ni,this.environmentIntensity=1,this.environmentRotation=new Ni,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}};var vo=class extends Wn{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Gn,u=Gn,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Af=new K,eb=new K,tb=new ot,Li=class{constructor(e=new K(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Af.subVectors(i,t).cross(eb.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t){let i=e.delta(Af),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let r=-(e.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:t.copy(e.start).addScaledVector(i,r)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||tb.getNormalMatrix(e),s=this.coplanarPoint(Af).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}},cr=new go,nb=new Lt(.5,.5),ac=new K,Ua=class{constructor(e=new Li,t=new Li,i=new Li,s=new Li,r=new Li,o=new Li){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Di){let i=this.planes,s=e.elements,r=s[0],o=s[1],a=s[2],l=s[3],c=s[4],u=s[5],h=s[6],f=s[7],d=s[8],_=s[9],v=s[10],m=s[11],p=s[12],T=s[13],S=s[14],b=s[15];if(i[0].setComponents(l-r,f-c,m-d,b-p).normalize(),i[1].setComponents(l+r,f+c,m+d,b+p).normalize(),i[2].setComponents(l+o,f+u,m+_,b+T).normalize(),i[3].setComponents(l-o,f-u,m-_,b-T).normalize(),i[4].setComponents(l-a,f-h,m-v,b-S).normalize(),t===Di)i[5].setComponents(l+a,f+h,m+v,b+S).normalize();else if(t===Sa)i[5].setComponents(a,h,v,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),cr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),cr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(cr)}intersectsSprite(e){cr.center.set(0,0,0);let t=nb.distanceTo(e.center);return cr.radius=.7071067811865476+t,cr.applyMatrix4(e.matrixWorld),this.intersectsSphere(cr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(ac.x=s.normal.x>0?e.max.x:e.min.x,ac.y=s.normal.y>0?e.max.y:e.min.y,ac.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(ac)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var Fa=class extends Wn{constructor(e,t,i=ks,s,r,o,a=Gn,l=Gn,c,u=po,h=1){if(u!==po&&u!==Eo)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new mo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}};var Na=class n extends pi{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,d=[],_=[],v=[],m=[];for(let p=0;p<u;p++){let T=p*f-o;for(let S=0;S<c;S++){let b=S*h-r;_.push(b,-T,0),v.push(0,0,1),m.push(S/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let T=0;T<a;T++){let S=T+c*p,b=T+c*(p+1),N=T+1+c*(p+1),L=T+1+c*p;d.push(S,b,L),d.push(b,N,L)}this.setIndex(d),this.setAttribute("position",new Ui(_,3)),this.setAttribute("normal",new Ui(v,3)),this.setAttribute("uv",new Ui(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var yo=class extends mi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Mc=class extends gr{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=E0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},wc=class extends gr{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function lc(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function ib(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}var _r=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},Sc=class extends _r{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Cf,endingEnd:Cf}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Rf:r=e,a=2*t-i;break;case If:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Rf:o=e,l=2*i-t;break;case If:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,_=(i-t)/(s-t),v=_*_,m=v*_,p=-f*m+2*f*v-f*_,T=(1+f)*m+(-1.5-2*f)*v+(-.5+f)*_+1,S=(-1-d)*m+(1.5+d)*v+.5*_,b=d*m-d*v;for(let N=0;N!==a;++N)r[N]=p*o[u+N]+T*o[c+N]+S*o[l+N]+b*o[h+N];return r}},Ec=class extends _r{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},Tc=class extends _r{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},si=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=lc(t,this.TimeBufferType),this.values=lc(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:lc(e.times,Array),values:lc(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s)}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Tc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Ec(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Sc(this.times,this.values,this.getValueSize(),e)}setInterpolation(e){let t;switch(e){case Ma:t=this.InterpolantFactoryMethodDiscrete;break;case pc:t=this.InterpolantFactoryMethodLinear;break;case cc:t=this.InterpolantFactoryMethodSmooth;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return console.warn("THREE.KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ma;case this.InterpolantFactoryMethodLinear:return pc;case this.InterpolantFactoryMethodSmooth:return cc}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&ib(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===cc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,f=h-i,d=h+i;for(let _=0;_!==i;++_){let v=t[h+_];if(v!==t[f+_]||v!==t[d+_]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,f=o*i;for(let d=0;d!==i;++d)t[f+d]=t[h+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,s}};si.prototype.ValueTypeName="";si.prototype.TimeBufferType=Float32Array;si.prototype.ValueBufferType=Float32Array;si.prototype.DefaultInterpolation=pc;var Us=class extends si{constructor(e,t,i){super(e,t,i)}};Us.prototype.ValueTypeName="bool";Us.prototype.ValueBufferType=Array;Us.prototype.DefaultInterpolation=Ma;Us.prototype.InterpolantFactoryMethodLinear=void 0;Us.prototype.InterpolantFactoryMethodSmooth=void 0;var Ac=class extends si{constructor(e,t,i,s){super(e,t,i,s)}};Ac.prototype.ValueTypeName="color";var Cc=class extends si{constructor(e,t,i,s){super(e,t,i,s)}};Cc.prototype.ValueTypeName="number";var Rc=class extends _r{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)os.slerpFlat(r,0,o,c-a,o,c,l);return r}},ka=class extends si{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Rc(this.times,this.values,this.getValueSize(),e)}};ka.prototype.ValueTypeName="quaternion";ka.prototype.InterpolantFactoryMethodSmooth=void 0;var Fs=class extends si{constructor(e,t,i){super(e,t,i)}};Fs.prototype.ValueTypeName="string";Fs.prototype.ValueBufferType=Array;Fs.prototype.DefaultInterpolation=Ma;Fs.prototype.InterpolantFactoryMethodLinear=void 0;Fs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ic=class extends si{constructor(e,t,i,s){super(e,t,i,s)}};Ic.prototype.ValueTypeName="vector";var Pc=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],_=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return _}return null}}},H0=new Pc,Lc=class{constructor(e){this.manager=e!==void 0?e:H0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}};Lc.DEFAULT_MATERIAL_NAME="__DEFAULT";var bo=class extends Pa{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Dc=class extends Hn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}};var jf="\\[\\]\\.:\\/",sb=new RegExp("["+jf+"]","g"),Qf="[^"+jf+"]",rb="[^"+jf.replace("\\.","")+"]",ob=/((?:WC+[\/:])*)/.source.replace("WC",Qf),ab=/(WCOD+)?/.source.replace("WCOD",rb),lb=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Qf),cb=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Qf),hb=new RegExp("^"+ob+ab+lb+cb+"$"),ub=["material","materials","bones","map"],Df=class{constructor(e,t,i){let s=i||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},qt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(sb,"")}static parseTrackName(e){let t=hb.exec(e);if(t===null)throw new Error("PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);ub.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=Df;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var MT=new Float32Array(1);function ed(n,e,t,i){let s=fb(i);switch(t){case Wf:return n*e;case qf:return n*e/s.components*s.byteLength;case $c:return n*e/s.components*s.byteLength;case $f:return n*e*2/s.components*s.byteLength;case Yc:return n*e*2/s.components*s.byteLength;case Xf:return n*e*3/s.components*s.byteLength;case kn:return n*e*4/s.components*s.byteLength;case Zc:return n*e*4/s.components*s.byteLength;case za:case Va:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ha:case Ga:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Kc:case Qc:return Math.max(n,16)*Math.max(e,8)/4;case Jc:case jc:return Math.max(n,8)*Math.max(e,8)/2;case eh:case th:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case nh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ih:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case sh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case rh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case oh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case ah:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case lh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case ch:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case hh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case uh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case fh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case dh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case ph:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case mh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case gh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Wa:case _h:case xh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Yf:case vh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case yh:case bh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function fb(n){switch(n){case ri:case Vf:return{byteLength:1,components:1};case Mo:case Hf:case wo:return{byteLength:2,components:1};case Xc:case qc:return{byteLength:2,components:4};case ks:case Wc:case oi:return{byteLength:4,components:1};case Gf:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"178"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="178");function f_(){let n=null,e=!1,t=null,i=null;function s(r,o){t(r,o),i=n.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function pb(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((d,_)=>d.start-_.start);let f=0;for(let d=1;d<h.length;d++){let _=h[f],v=h[d];v.start<=_.start+_.count+1?_.count=Math.max(_.count,v.start+v.count-_.start):(++f,h[f]=v)}h.length=f+1;for(let d=0,_=h.length;d<_;d++){let v=h[d];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var mb=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,gb=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,_b=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,xb=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,vb=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,yb=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,bb=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Mb=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,wb=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,Sb=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Eb=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Tb=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Ab=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Cb=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Rb=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Ib=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Pb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Lb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Db=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Ub=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Fb=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Nb=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,kb=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,Ob=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Bb=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,zb=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,Vb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Hb=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Gb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Wb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Xb="gl_FragColor = linearToOutputTexel( gl_FragColor );",qb=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,$b=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,Yb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,Zb=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Jb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Kb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,jb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Qb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,eM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,tM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,nM=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,iM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,sM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,rM=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,oM=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,aM=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,lM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,cM=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,hM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,uM=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,fM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,dM=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,pM=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,mM=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,gM=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,_M=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,xM=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,vM=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,yM=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,bM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,MM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,wM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,SM=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,EM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,TM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,AM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,CM=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,RM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,IM=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,PM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,LM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,DM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,UM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,FM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,NM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,kM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,OM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,BM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,zM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,VM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,HM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,GM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,WM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,XM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,qM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,$M=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,YM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,ZM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,JM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		return step( compare, unpackRGBAToDepth( texture2D( depths, uv ) ) );
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow (sampler2D shadow, vec2 uv, float compare ){
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		float hard_shadow = step( compare , distribution.x );
		if (hard_shadow != 1.0 ) {
			float distance = compare - distribution.x ;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,KM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,jM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,QM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,ew=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,tw=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,nw=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,iw=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,sw=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,rw=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ow=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,aw=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,lw=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,cw=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,hw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,uw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,fw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,dw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,pw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,mw=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,gw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,_w=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,xw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,bw=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	float fragCoordZ = 0.5 * vHighPrecisionZW[0] / vHighPrecisionZW[1] + 0.5;
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Mw=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,ww=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,Sw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ew=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Tw=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Aw=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Cw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Rw=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Iw=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Pw=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Lw=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Dw=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Uw=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Fw=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Nw=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,kw=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ow=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Bw=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,zw=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Vw=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Hw=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Gw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ww=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Xw=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,qw=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,$w=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ht={alphahash_fragment:mb,alphahash_pars_fragment:gb,alphamap_fragment:_b,alphamap_pars_fragment:xb,alphatest_fragment:vb,alphatest_pars_fragment:yb,aomap_fragment:bb,aomap_pars_fragment:Mb,batching_pars_vertex:wb,batching_vertex:Sb,begin_vertex:Eb,beginnormal_vertex:Tb,bsdfs:Ab,iridescence_fragment:Cb,bumpmap_pars_fragment:Rb,clipping_planes_fragment:Ib,clipping_planes_pars_fragment:Pb,clipping_planes_pars_vertex:Lb,clipping_planes_vertex:Db,color_fragment:Ub,color_pars_fragment:Fb,color_pars_vertex:Nb,color_vertex:kb,common:Ob,cube_uv_reflection_fragment:Bb,defaultnormal_vertex:zb,displacementmap_pars_vertex:Vb,displacementmap_vertex:Hb,emissivemap_fragment:Gb,emissivemap_pars_fragment:Wb,colorspace_fragment:Xb,colorspace_pars_fragment:qb,envmap_fragment:$b,envmap_common_pars_fragment:Yb,envmap_pars_fragment:Zb,envmap_pars_vertex:Jb,envmap_physical_pars_fragment:aM,envmap_vertex:Kb,fog_vertex:jb,fog_pars_vertex:Qb,fog_fragment:eM,fog_pars_fragment:tM,gradientmap_pars_fragment:nM,lightmap_pars_fragment:iM,lights_lambert_fragment:sM,lights_lambert_pars_fragment:rM,lights_pars_begin:oM,lights_toon_fragment:lM,lights_toon_pars_fragment:cM,lights_phong_fragment:hM,lights_phong_pars_fragment:uM,lights_physical_fragment:fM,lights_physical_pars_fragment:dM,lights_fragment_begin:pM,lights_fragment_maps:mM,lights_fragment_end:gM,logdepthbuf_fragment:_M,logdepthbuf_pars_fragment:xM,logdepthbuf_pars_vertex:vM,logdepthbuf_vertex:yM,map_fragment:bM,map_pars_fragment:MM,map_particle_fragment:wM,map_particle_pars_fragment:SM,metalnessmap_fragment:EM,metalnessmap_pars_fragment:TM,morphinstance_vertex:AM,morphcolor_vertex:CM,morphnormal_vertex:RM,morphtarget_pars_vertex:IM,morphtarget_vertex:PM,normal_fragment_begin:LM,normal_fragment_maps:DM,normal_pars_fragment:UM,normal_pars_vertex:FM,normal_vertex:NM,normalmap_pars_fragment:kM,clearcoat_normal_fragment_begin:OM,clearcoat_normal_fragment_maps:BM,clearcoat_pars_fragment:zM,iridescence_pars_fragment:VM,opaque_fragment:HM,packing:GM,premultiplied_alpha_fragment:WM,project_vertex:XM,dithering_fragment:qM,dithering_pars_fragment:$M,roughnessmap_fragment:YM,roughnessmap_pars_fragment:ZM,shadowmap_pars_fragment:JM,shadowmap_pars_vertex:KM,shadowmap_vertex:jM,shadowmask_pars_fragment:QM,skinbase_vertex:ew,skinning_pars_vertex:tw,skinning_vertex:nw,skinnormal_vertex:iw,specularmap_fragment:sw,specularmap_pars_fragment:rw,tonemapping_fragment:ow,tonemapping_pars_fragment:aw,transmission_fragment:lw,transmission_pars_fragment:cw,uv_pars_fragment:hw,uv_pars_vertex:uw,uv_vertex:fw,worldpos_vertex:dw,background_vert:pw,background_frag:mw,backgroundCube_vert:gw,backgroundCube_frag:_w,cube_vert:xw,cube_frag:vw,depth_vert:yw,depth_frag:bw,distanceRGBA_vert:Mw,distanceRGBA_frag:ww,equirect_vert:Sw,equirect_frag:Ew,linedashed_vert:Tw,linedashed_frag:Aw,meshbasic_vert:Cw,meshbasic_frag:Rw,meshlambert_vert:Iw,meshlambert_frag:Pw,meshmatcap_vert:Lw,meshmatcap_frag:Dw,meshnormal_vert:Uw,meshnormal_frag:Fw,meshphong_vert:Nw,meshphong_frag:kw,meshphysical_vert:Ow,meshphysical_frag:Bw,meshtoon_vert:zw,meshtoon_frag:Vw,points_vert:Hw,points_frag:Gw,shadow_vert:Ww,shadow_frag:Xw,sprite_vert:qw,sprite_frag:$w},Ee={common:{diffuse:{value:new At(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ot}},envmap:{envMap:{value:null},envMapRotation:{value:new ot},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ot}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ot}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ot},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ot},normalScale:{value:new Lt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ot},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ot}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ot}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ot}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new At(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new At(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0},uvTransform:{value:new ot}},sprite:{diffuse:{value:new At(16777215)},opacity:{value:1},center:{value:new Lt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}}},Bi={basic:{uniforms:An([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:An([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,Ee.lights,{emissive:{value:new At(0)}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:An([Ee.common,Ee.specularmap,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,Ee.lights,{emissive:{value:new At(0)},specular:{value:new At(1118481)},shininess:{value:30}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:An([Ee.common,Ee.envmap,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.roughnessmap,Ee.metalnessmap,Ee.fog,Ee.lights,{emissive:{value:new At(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:An([Ee.common,Ee.aomap,Ee.lightmap,Ee.emissivemap,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.gradientmap,Ee.fog,Ee.lights,{emissive:{value:new At(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:An([Ee.common,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,Ee.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:An([Ee.points,Ee.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:An([Ee.common,Ee.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:An([Ee.common,Ee.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:An([Ee.common,Ee.bumpmap,Ee.normalmap,Ee.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:An([Ee.sprite,Ee.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new ot},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ot}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distanceRGBA:{uniforms:An([Ee.common,Ee.displacementmap,{referencePosition:{value:new K},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distanceRGBA_vert,fragmentShader:ht.distanceRGBA_frag},shadow:{uniforms:An([Ee.lights,Ee.fog,{color:{value:new At(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};Bi.physical={uniforms:An([Bi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ot},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ot},clearcoatNormalScale:{value:new Lt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ot},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ot},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ot},sheen:{value:0},sheenColor:{value:new At(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ot},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ot},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ot},transmissionSamplerSize:{value:new Lt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ot},attenuationDistance:{value:0},attenuationColor:{value:new At(0)},specularColor:{value:new At(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ot},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ot},anisotropyVector:{value:new Lt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ot}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var Mh={r:0,b:0,g:0},br=new Ni,Yw=new on;function Zw(n,e,t,i,s,r,o){let a=new At(0),l=r===!0?0:1,c,u,h=null,f=0,d=null;function _(S){let b=S.isScene===!0?S.background:null;return b&&b.isTexture&&(b=(S.backgroundBlurriness>0?t:e).get(b)),b}function v(S){let b=!1,N=_(S);N===null?p(a,l):N&&N.isColor&&(p(N,1),b=!0);let L=n.xr.getEnvironmentBlendMode();L==="additive"?i.buffers.color.setClear(0,0,0,1,o):L==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,o),(n.autoClear||b)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function m(S,b){let N=_(b);N&&(N.isCubeTexture||N.mapping===Oa)?(u===void 0&&(u=new Fn(new _o(1,1,1),new mi({name:"BackgroundCubeMaterial",uniforms:yr(Bi.backgroundCube.uniforms),vertexShader:Bi.backgroundCube.vertexShader,fragmentShader:Bi.backgroundCube.fragmentShader,side:Nn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(L,D,B){this.matrixWorld.copyPosition(B.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),br.copy(b.backgroundRotation),br.x*=-1,br.y*=-1,br.z*=-1,N.isCubeTexture&&N.isRenderTargetTexture===!1&&(br.y*=-1,br.z*=-1),u.material.uniforms.envMap.value=N,u.material.uniforms.flipEnvMap.value=N.isCubeTexture&&N.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=b.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(Yw.makeRotationFromEuler(br)),u.material.toneMapped=mt.getTransfer(N.colorSpace)!==Pt,(h!==N||f!==N.version||d!==n.toneMapping)&&(u.material.needsUpdate=!0,h=N,f=N.version,d=n.toneMapping),u.layers.enableAll(),S.unshift(u,u.geometry,u.material,0,0,null)):N&&N.isTexture&&(c===void 0&&(c=new Fn(new Na(2,2),new mi({name:"BackgroundMaterial",uniforms:yr(Bi.background.uniforms),vertexShader:Bi.background.vertexShader,fragmentShader:Bi.background.fragmentShader,side:ss,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=N,c.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,c.material.toneMapped=mt.getTransfer(N.colorSpace)!==Pt,N.matrixAutoUpdate===!0&&N.updateMatrix(),c.material.uniforms.uvTransform.value.copy(N.matrix),(h!==N||f!==N.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=N,f=N.version,d=n.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null))}function p(S,b){S.getRGB(Mh,Kf(n)),i.buffers.color.setClear(Mh.r,Mh.g,Mh.b,b,o)}function T(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(S,b=1){a.set(S),l=b,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(S){l=S,p(a,l)},render:v,addToRenderList:m,dispose:T}}function Jw(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(M,I,q,z,W){let Y=!1,$=h(z,q,I);r!==$&&(r=$,c(r.object)),Y=d(M,z,q,W),Y&&_(M,z,q,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,b(M,I,q,z),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(M){return n.bindVertexArray(M)}function u(M){return n.deleteVertexArray(M)}function h(M,I,q){let z=q.wireframe===!0,W=i[M.id];W===void 0&&(W={},i[M.id]=W);let Y=W[I.id];Y===void 0&&(Y={},W[I.id]=Y);let $=Y[z];return $===void 0&&($=f(l()),Y[z]=$),$}function f(M){let I=[],q=[],z=[];for(let W=0;W<t;W++)I[W]=0,q[W]=0,z[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:I,enabledAttributes:q,attributeDivisors:z,object:M,attributes:{},index:null}}function d(M,I,q,z){let W=r.attributes,Y=I.attributes,$=0,j=q.getAttributes();for(let Q in j)if(j[Q].location>=0){let ce=W[Q],_e=Y[Q];if(_e===void 0&&(Q==="instanceMatrix"&&M.instanceMatrix&&(_e=M.instanceMatrix),Q==="instanceColor"&&M.instanceColor&&(_e=M.instanceColor)),ce===void 0||ce.attribute!==_e||_e&&ce.data!==_e.data)return!0;$++}return r.attributesNum!==$||r.index!==z}function _(M,I,q,z){let W={},Y=I.attributes,$=0,j=q.getAttributes();for(let Q in j)if(j[Q].location>=0){let ce=Y[Q];ce===void 0&&(Q==="instanceMatrix"&&M.instanceMatrix&&(ce=M.instanceMatrix),Q==="instanceColor"&&M.instanceColor&&(ce=M.instanceColor));let _e={};_e.attribute=ce,ce&&ce.data&&(_e.data=ce.data),W[Q]=_e,$++}r.attributes=W,r.attributesNum=$,r.index=z}function v(){let M=r.newAttributes;for(let I=0,q=M.length;I<q;I++)M[I]=0}function m(M){p(M,0)}function p(M,I){let q=r.newAttributes,z=r.enabledAttributes,W=r.attributeDivisors;q[M]=1,z[M]===0&&(n.enableVertexAttribArray(M),z[M]=1),W[M]!==I&&(n.vertexAttribDivisor(M,I),W[M]=I)}function T(){let M=r.newAttributes,I=r.enabledAttributes;for(let q=0,z=I.length;q<z;q++)I[q]!==M[q]&&(n.disableVertexAttribArray(q),I[q]=0)}function S(M,I,q,z,W,Y,$){$===!0?n.vertexAttribIPointer(M,I,q,W,Y):n.vertexAttribPointer(M,I,q,z,W,Y)}function b(M,I,q,z){v();let W=z.attributes,Y=q.getAttributes(),$=I.defaultAttributeValues;for(let j in Y){let Q=Y[j];if(Q.location>=0){let he=W[j];if(he===void 0&&(j==="instanceMatrix"&&M.instanceMatrix&&(he=M.instanceMatrix),j==="instanceColor"&&M.instanceColor&&(he=M.instanceColor)),he!==void 0){let ce=he.normalized,_e=he.itemSize,Se=e.get(he);if(Se===void 0)continue;let me=Se.buffer,ee=Se.type,ue=Se.bytesPerElement,ve=ee===n.INT||ee===n.UNSIGNED_INT||he.gpuType===Wc;if(he.isInterleavedBufferAttribute){let ae=he.data,Ne=ae.stride,tt=he.offset;if(ae.isInstancedInterleavedBuffer){for(let Ce=0;Ce<Q.locationSize;Ce++)p(Q.location+Ce,ae.meshPerAttribute);M.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=ae.meshPerAttribute*ae.count)}else for(let Ce=0;Ce<Q.locationSize;Ce++)m(Q.location+Ce);n.bindBuffer(n.ARRAY_BUFFER,me);for(let Ce=0;Ce<Q.locationSize;Ce++)S(Q.location+Ce,_e/Q.locationSize,ee,ce,Ne*ue,(tt+_e/Q.locationSize*Ce)*ue,ve)}else{if(he.isInstancedBufferAttribute){for(let ae=0;ae<Q.locationSize;ae++)p(Q.location+ae,he.meshPerAttribute);M.isInstancedMesh!==!0&&z._maxInstanceCount===void 0&&(z._maxInstanceCount=he.meshPerAttribute*he.count)}else for(let ae=0;ae<Q.locationSize;ae++)m(Q.location+ae);n.bindBuffer(n.ARRAY_BUFFER,me);for(let ae=0;ae<Q.locationSize;ae++)S(Q.location+ae,_e/Q.locationSize,ee,ce,_e*ue,_e/Q.locationSize*ae*ue,ve)}}else if($!==void 0){let ce=$[j];if(ce!==void 0)switch(ce.length){case 2:n.vertexAttrib2fv(Q.location,ce);break;case 3:n.vertexAttrib3fv(Q.location,ce);break;case 4:n.vertexAttrib4fv(Q.location,ce);break;default:n.vertexAttrib1fv(Q.location,ce)}}}}T()}function N(){B();for(let M in i){let I=i[M];for(let q in I){let z=I[q];for(let W in z)u(z[W].object),delete z[W];delete I[q]}delete i[M]}}function L(M){if(i[M.id]===void 0)return;let I=i[M.id];for(let q in I){let z=I[q];for(let W in z)u(z[W].object),delete z[W];delete I[q]}delete i[M.id]}function D(M){for(let I in i){let q=i[I];if(q[M.id]===void 0)continue;let z=q[M.id];for(let W in z)u(z[W].object),delete z[W];delete q[M.id]}}function B(){E(),o=!0,r!==s&&(r=s,c(r.object))}function E(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:E,dispose:N,releaseStatesOfGeometry:L,releaseStatesOfProgram:D,initAttributes:v,enableAttribute:m,disableUnusedAttributes:T}}function Kw(n,e,t){let i;function s(c){i=c}function r(c,u){n.drawArrays(i,c,u),t.update(u,i,1)}function o(c,u,h){h!==0&&(n.drawArraysInstanced(i,c,u,h),t.update(u,i,h))}function a(c,u,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,u,0,h);let d=0;for(let _=0;_<h;_++)d+=u[_];t.update(d,i,1)}function l(c,u,h,f){if(h===0)return;let d=e.get("WEBGL_multi_draw");if(d===null)for(let _=0;_<c.length;_++)o(c[_],u[_],f[_]);else{d.multiDrawArraysInstancedWEBGL(i,c,0,u,0,f,0,h);let _=0;for(let v=0;v<h;v++)_+=u[v]*f[v];t.update(_,i,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function jw(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let D=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==kn&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){let B=D===wo&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(D!==ri&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==oi&&!B)}function l(D){if(D==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.logarithmicDepthBuffer===!0,f=t.reverseDepthBuffer===!0&&e.has("EXT_clip_control"),d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),T=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),S=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),N=_>0,L=n.getParameter(n.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reverseDepthBuffer:f,maxTextures:d,maxVertexTextures:_,maxTextureSize:v,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:T,maxVaryings:S,maxFragmentUniforms:b,vertexTextures:N,maxSamples:L}}function Qw(n){let e=this,t=null,i=0,s=!1,r=!1,o=new Li,a=new ot,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||i!==0||s;return s=f,i=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,d){let _=h.clippingPlanes,v=h.clipIntersection,m=h.clipShadows,p=n.get(h);if(!s||_===null||_.length===0||r&&!m)r?u(null):c();else{let T=r?0:i,S=T*4,b=p.clippingState||null;l.value=b,b=u(_,f,S,d);for(let N=0;N!==S;++N)b[N]=t[N];p.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=T}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,f,d,_){let v=h!==null?h.length:0,m=null;if(v!==0){if(m=l.value,_!==!0||m===null){let p=d+v*4,T=f.matrixWorldInverse;a.getNormalMatrix(T),(m===null||m.length<p)&&(m=new Float32Array(p));for(let S=0,b=d;S!==v;++S,b+=4)o.copy(h[S]).applyMatrix4(T,a),o.normal.toArray(m,b),m[b+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,m}}function eS(n){let e=new WeakMap;function t(o,a){return a===Vc?o.mapping=xr:a===Hc&&(o.mapping=vr),o}function i(o){if(o&&o.isTexture){let a=o.mapping;if(a===Vc||a===Hc)if(e.has(o)){let l=e.get(o).texture;return t(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new bc(l.height);return c.fromEquirectangularTexture(n,o),e.set(o,c),o.addEventListener("dispose",s),t(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=e.get(a);l!==void 0&&(e.delete(a),l.dispose())}function r(){e=new WeakMap}return{get:i,dispose:r}}var Co=4,G0=[.125,.215,.35,.446,.526,.582],Sr=20,td=new bo,W0=new At,nd=null,id=0,sd=0,rd=!1,wr=(1+Math.sqrt(5))/2,Ao=1/wr,X0=[new K(-wr,Ao,0),new K(wr,Ao,0),new K(-Ao,0,wr),new K(Ao,0,wr),new K(0,wr,-Ao),new K(0,wr,Ao),new K(-1,1,-1),new K(1,1,-1),new K(-1,1,1),new K(1,1,1)],tS=new K,Eh=class{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=tS}=r;nd=this._renderer.getRenderTarget(),id=this._renderer.getActiveCubeFace(),sd=this._renderer.getActiveMipmapLevel(),rd=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(e,i,s,l,a),t>0&&this._blur(l,0,0,t),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Y0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=$0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodPlanes.length;e++)this._lodPlanes[e].dispose()}_cleanup(e){this._renderer.setRenderTarget(nd,id,sd),this._renderer.xr.enabled=rd,e.scissorTest=!1,wh(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===xr||e.mapping===vr?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),nd=this._renderer.getRenderTarget(),id=this._renderer.getActiveCubeFace(),sd=this._renderer.getActiveMipmapLevel(),rd=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let i=t||this._allocateTargets();return this._textureToCubeUV(e,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){let e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,i={magFilter:ii,minFilter:ii,generateMipmaps:!1,type:wo,format:kn,colorSpace:pr,depthBuffer:!1},s=q0(e,t,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=q0(e,t,i);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=nS(r)),this._blurMaterial=iS(r,e,t)}return s}_compileMaterial(e){let t=new Fn(this._lodPlanes[0],e);this._renderer.compile(t,td)}_sceneToCubeUV(e,t,i,s,r){let l=new Hn(90,1,t,i),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,f=h.autoClear,d=h.toneMapping;h.getClearColor(W0),h.toneMapping=ls,h.autoClear=!1;let _=new Ca({name:"PMREM.Background",side:Nn,depthWrite:!1,depthTest:!1}),v=new Fn(new _o,_),m=!1,p=e.background;p?p.isColor&&(_.color.copy(p),e.background=null,m=!0):(_.color.copy(W0),m=!0);for(let T=0;T<6;T++){let S=T%3;S===0?(l.up.set(0,c[T],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[T],r.y,r.z)):S===1?(l.up.set(0,0,c[T]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[T],r.z)):(l.up.set(0,c[T],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[T]));let b=this._cubeSize;wh(s,S*b,T>2?b:0,b,b),h.setRenderTarget(s),m&&h.render(v,l),h.render(e,l)}v.geometry.dispose(),v.material.dispose(),h.toneMapping=d,h.autoClear=f,e.background=p}_textureToCubeUV(e,t){let i=this._renderer,s=e.mapping===xr||e.mapping===vr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=Y0()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=$0());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new Fn(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=e;let l=this._cubeSize;wh(t,0,0,3*l,2*l),i.setRenderTarget(t),i.render(o,td)}_applyPMREM(e){let t=this._renderer,i=t.autoClear;t.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=X0[(s-r-1)%X0.length];this._blur(e,r-1,r,o,a)}t.autoClear=i}_blur(e,t,i,s,r){let o=this._pingPongRenderTarget;this._halfBlur(e,o,t,i,s,"latitudinal",r),this._halfBlur(o,e,i,i,s,"longitudinal",r)}_halfBlur(e,t,i,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let u=3,h=new Fn(this._lodPlanes[s],c),f=c.uniforms,d=this._sizeLods[i]-1,_=isFinite(r)?Math.PI/(2*d):2*Math.PI/(2*Sr-1),v=r/_,m=isFinite(r)?1+Math.floor(u*v):Sr;m>Sr&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${Sr}`);let p=[],T=0;for(let D=0;D<Sr;++D){let B=D/v,E=Math.exp(-B*B/2);p.push(E),D===0?T+=E:D<m&&(T+=2*E)}for(let D=0;D<p.length;D++)p[D]=p[D]/T;f.envMap.value=e.texture,f.samples.value=m,f.weights.value=p,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);let{_lodMax:S}=this;f.dTheta.value=_,f.mipInt.value=S-i;let b=this._sizeLods[s],N=3*b*(s>S-Co?s-S+Co:0),L=4*(this._cubeSize-b);wh(t,N,L,3*b,2*b),l.setRenderTarget(t),l.render(h,td)}};function nS(n){let e=[],t=[],i=[],s=n,r=n-Co+1+G0.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);t.push(a);let l=1/a;o>n-Co?l=G0[o-n+Co-1]:o===0&&(l=0),i.push(l);let c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],d=6,_=6,v=3,m=2,p=1,T=new Float32Array(v*_*d),S=new Float32Array(m*_*d),b=new Float32Array(p*_*d);for(let L=0;L<d;L++){let D=L%3*2/3-1,B=L>2?0:-1,E=[D,B,0,D+2/3,B,0,D+2/3,B+1,0,D,B,0,D+2/3,B+1,0,D,B+1,0];T.set(E,v*_*L),S.set(f,m*_*L);let M=[L,L,L,L,L,L];b.set(M,p*_*L)}let N=new pi;N.setAttribute("position",new dn(T,v)),N.setAttribute("uv",new dn(S,m)),N.setAttribute("faceIndex",new dn(b,p)),e.push(N),s>Co&&s--}return{lodPlanes:e,sizeLods:t,sigmas:i}}function q0(n,e,t){let i=new Fi(n,e,t);return i.texture.mapping=Oa,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function wh(n,e,t,i,s){n.viewport.set(e,t,i,s),n.scissor.set(e,t,i,s)}function iS(n,e,t){let i=new Float32Array(Sr),s=new K(0,1,0);return new mi({name:"SphericalGaussianBlur",defines:{n:Sr,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:md(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:as,depthTest:!1,depthWrite:!1})}function $0(){return new mi({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:md(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:as,depthTest:!1,depthWrite:!1})}function Y0(){return new mi({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:md(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:as,depthTest:!1,depthWrite:!1})}function md(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function sS(n){let e=new WeakMap,t=null;function i(a){if(a&&a.isTexture){let l=a.mapping,c=l===Vc||l===Hc,u=l===xr||l===vr;if(c||u){let h=e.get(a),f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return t===null&&(t=new Eh(n)),h=c?t.fromEquirectangular(a,h):t.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),h.texture;if(h!==void 0)return h.texture;{let d=a.image;return c&&d&&d.height>0||u&&d&&s(d)?(t===null&&(t=new Eh(n)),h=c?t.fromEquirectangular(a):t.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,e.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0,c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=e.get(l);c!==void 0&&(e.delete(l),c.dispose())}function o(){e=new WeakMap,t!==null&&(t.dispose(),t=null)}return{get:i,dispose:o}}function rS(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s;switch(i){case"WEBGL_depth_texture":s=n.getExtension("WEBGL_depth_texture")||n.getExtension("MOZ_WEBGL_depth_texture")||n.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=n.getExtension("EXT_texture_filter_anisotropic")||n.getExtension("MOZ_EXT_texture_filter_anisotropic")||n.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=n.getExtension("WEBGL_compressed_texture_s3tc")||n.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=n.getExtension("WEBGL_compressed_texture_pvrtc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=n.getExtension(i)}return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&mr("THREE.WebGLRenderer: "+i+" extension not supported."),s}}}function oS(n,e,t,i){let s={},r=new WeakMap;function o(h){let f=h.target;f.index!==null&&e.remove(f.index);for(let _ in f.attributes)e.remove(f.attributes[_]);f.removeEventListener("dispose",o),delete s[f.id];let d=r.get(f);d&&(e.remove(d),r.delete(f)),i.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,t.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,t.memory.geometries++),f}function l(h){let f=h.attributes;for(let d in f)e.update(f[d],n.ARRAY_BUFFER)}function c(h){let f=[],d=h.index,_=h.attributes.position,v=0;if(d!==null){let T=d.array;v=d.version;for(let S=0,b=T.length;S<b;S+=3){let N=T[S+0],L=T[S+1],D=T[S+2];f.push(N,L,L,D,D,N)}}else if(_!==void 0){let T=_.array;v=_.version;for(let S=0,b=T.length/3-1;S<b;S+=3){let N=S+0,L=S+1,D=S+2;f.push(N,L,L,D,D,N)}}else return;let m=new(Jf(f)?Ia:Ra)(f,1);m.version=v;let p=r.get(h);p&&e.remove(p),r.set(h,m)}function u(h){let f=r.get(h);if(f){let d=h.index;d!==null&&f.version<d.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function aS(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,d){n.drawElements(i,d,r,f*o),t.update(d,i,1)}function c(f,d,_){_!==0&&(n.drawElementsInstanced(i,d,r,f*o,_),t.update(d,i,_))}function u(f,d,_){if(_===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,f,0,_);let m=0;for(let p=0;p<_;p++)m+=d[p];t.update(m,i,1)}function h(f,d,_,v){if(_===0)return;let m=e.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<f.length;p++)c(f[p]/o,d[p],v[p]);else{m.multiDrawElementsInstancedWEBGL(i,d,0,r,f,0,v,0,_);let p=0;for(let T=0;T<_;T++)p+=d[T]*v[T];t.update(p,i,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function lS(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function cS(n,e,t){let i=new WeakMap,s=new Yt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let E=function(){D.dispose(),i.delete(a),a.removeEventListener("dispose",E)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],T=a.morphAttributes.color||[],S=0;d===!0&&(S=1),_===!0&&(S=2),v===!0&&(S=3);let b=a.attributes.position.count*S,N=1;b>e.maxTextureSize&&(N=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let L=new Float32Array(b*N*4*h),D=new Ta(L,b,N,h);D.type=oi,D.needsUpdate=!0;let B=S*4;for(let M=0;M<h;M++){let I=m[M],q=p[M],z=T[M],W=b*N*4*M;for(let Y=0;Y<I.count;Y++){let $=Y*B;d===!0&&(s.fromBufferAttribute(I,Y),L[W+$+0]=s.x,L[W+$+1]=s.y,L[W+$+2]=s.z,L[W+$+3]=0),_===!0&&(s.fromBufferAttribute(q,Y),L[W+$+4]=s.x,L[W+$+5]=s.y,L[W+$+6]=s.z,L[W+$+7]=0),v===!0&&(s.fromBufferAttribute(z,Y),L[W+$+8]=s.x,L[W+$+9]=s.y,L[W+$+10]=s.z,L[W+$+11]=z.itemSize===4?s.w:1)}}f={count:h,texture:D,size:new Lt(b,N)},i.set(a,f),a.addEventListener("dispose",E)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let v=0;v<c.length;v++)d+=c[v];let _=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",_),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function hS(n,e,t,i){let s=new WeakMap;function r(l){let c=i.render.frame,u=l.geometry,h=e.get(l,u);if(s.get(h)!==c&&(e.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(t.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),t.remove(c.instanceMatrix),c.instanceColor!==null&&t.remove(c.instanceColor)}return{update:r,dispose:o}}var d_=new Wn,Z0=new Fa(1,1),p_=new Ta,m_=new xc,g_=new La,J0=[],K0=[],j0=new Float32Array(16),Q0=new Float32Array(9),e_=new Float32Array(4);function Io(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=J0[s];if(r===void 0&&(r=new Float32Array(s),J0[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function pn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function mn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Ah(n,e){let t=K0[e];t===void 0&&(t=new Int32Array(e),K0[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function uS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function fS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(pn(t,e))return;n.uniform2fv(this.addr,e),mn(t,e)}}function dS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(pn(t,e))return;n.uniform3fv(this.addr,e),mn(t,e)}}function pS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(pn(t,e))return;n.uniform4fv(this.addr,e),mn(t,e)}}function mS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(pn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),mn(t,e)}else{if(pn(t,i))return;e_.set(i),n.uniformMatrix2fv(this.addr,!1,e_),mn(t,i)}}function gS(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(pn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),mn(t,e)}else{if(pn(t,i))return;Q0.set(i),n.uniformMatrix3fv(this.addr,!1,Q0),mn(t,i)}}function _S(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(pn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),mn(t,e)}else{if(pn(t,i))return;j0.set(i),n.uniformMatrix4fv(this.addr,!1,j0),mn(t,i)}}function xS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function vS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(pn(t,e))return;n.uniform2iv(this.addr,e),mn(t,e)}}function yS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(pn(t,e))return;n.uniform3iv(this.addr,e),mn(t,e)}}function bS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(pn(t,e))return;n.uniform4iv(this.addr,e),mn(t,e)}}function MS(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function wS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(pn(t,e))return;n.uniform2uiv(this.addr,e),mn(t,e)}}function SS(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(pn(t,e))return;n.uniform3uiv(this.addr,e),mn(t,e)}}function ES(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(pn(t,e))return;n.uniform4uiv(this.addr,e),mn(t,e)}}function TS(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(Z0.compareFunction=Zf,r=Z0):r=d_,t.setTexture2D(e||r,s)}function AS(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||m_,s)}function CS(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTextureCube(e||g_,s)}function RS(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||p_,s)}function IS(n){switch(n){case 5126:return uS;case 35664:return fS;case 35665:return dS;case 35666:return pS;case 35674:return mS;case 35675:return gS;case 35676:return _S;case 5124:case 35670:return xS;case 35667:case 35671:return vS;case 35668:case 35672:return yS;case 35669:case 35673:return bS;case 5125:return MS;case 36294:return wS;case 36295:return SS;case 36296:return ES;case 35678:case 36198:case 36298:case 36306:case 35682:return TS;case 35679:case 36299:case 36307:return AS;case 35680:case 36300:case 36308:case 36293:return CS;case 36289:case 36303:case 36311:case 36292:return RS}}function PS(n,e){n.uniform1fv(this.addr,e)}function LS(n,e){let t=Io(e,this.size,2);n.uniform2fv(this.addr,t)}function DS(n,e){let t=Io(e,this.size,3);n.uniform3fv(this.addr,t)}function US(n,e){let t=Io(e,this.size,4);n.uniform4fv(this.addr,t)}function FS(n,e){let t=Io(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function NS(n,e){let t=Io(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function kS(n,e){let t=Io(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function OS(n,e){n.uniform1iv(this.addr,e)}function BS(n,e){n.uniform2iv(this.addr,e)}function zS(n,e){n.uniform3iv(this.addr,e)}function VS(n,e){n.uniform4iv(this.addr,e)}function HS(n,e){n.uniform1uiv(this.addr,e)}function GS(n,e){n.uniform2uiv(this.addr,e)}function WS(n,e){n.uniform3uiv(this.addr,e)}function XS(n,e){n.uniform4uiv(this.addr,e)}function qS(n,e,t){let i=this.cache,s=e.length,r=Ah(t,s);pn(i,r)||(n.uniform1iv(this.addr,r),mn(i,r));for(let o=0;o!==s;++o)t.setTexture2D(e[o]||d_,r[o])}function $S(n,e,t){let i=this.cache,s=e.length,r=Ah(t,s);pn(i,r)||(n.uniform1iv(this.addr,r),mn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||m_,r[o])}function YS(n,e,t){let i=this.cache,s=e.length,r=Ah(t,s);pn(i,r)||(n.uniform1iv(this.addr,r),mn(i,r));for(let o=0;o!==s;++o)t.setTextureCube(e[o]||g_,r[o])}function ZS(n,e,t){let i=this.cache,s=e.length,r=Ah(t,s);pn(i,r)||(n.uniform1iv(this.addr,r),mn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||p_,r[o])}function JS(n){switch(n){case 5126:return PS;case 35664:return LS;case 35665:return DS;case 35666:return US;case 35674:return FS;case 35675:return NS;case 35676:return kS;case 5124:case 35670:return OS;case 35667:case 35671:return BS;case 35668:case 35672:return zS;case 35669:case 35673:return VS;case 5125:return HS;case 36294:return GS;case 36295:return WS;case 36296:return XS;case 35678:case 36198:case 36298:case 36306:case 35682:return qS;case 35679:case 36299:case 36307:return $S;case 35680:case 36300:case 36308:case 36293:return YS;case 36289:case 36303:case 36311:case 36292:return ZS}}var ad=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=IS(t.type)}},ld=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=JS(t.type)}},cd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},od=/(\w+)(\])?(\[|\.)?/g;function t_(n,e){n.seq.push(e),n.map[e.id]=e}function KS(n,e,t){let i=n.name,s=i.length;for(od.lastIndex=0;;){let r=od.exec(i),o=od.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){t_(t,c===void 0?new ad(a,n,e):new ld(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new cd(a),t_(t,h)),t=h}}}var Ro=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let s=0;s<i;++s){let r=e.getActiveUniform(t,s),o=e.getUniformLocation(t,r.name);KS(r,o,this)}}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function n_(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var jS=37297,QS=0;function e1(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var i_=new ot;function t1(n){mt._getMatrix(i_,mt.workingColorSpace,n);let e=`mat3( ${i_.elements.map(t=>t.toFixed(4))} )`;switch(mt.getTransfer(n)){case wa:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function s_(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),s=n.getShaderInfoLog(e).trim();if(i&&s==="")return"";let r=/ERROR: 0:(\d+)/.exec(s);if(r){let o=parseInt(r[1]);return t.toUpperCase()+`

`+s+`

`+e1(n.getShaderSource(e),o)}else return s}function n1(n,e){let t=t1(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}function i1(n,e){let t;switch(e){case _0:t="Linear";break;case x0:t="Reinhard";break;case v0:t="Cineon";break;case y0:t="ACESFilmic";break;case M0:t="AgX";break;case w0:t="Neutral";break;case b0:t="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",e),t="Linear"}return"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Sh=new K;function s1(){mt.getLuminanceCoefficients(Sh);let n=Sh.x.toFixed(4),e=Sh.y.toFixed(4),t=Sh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function r1(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(qa).join(`
`)}function o1(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function a1(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function qa(n){return n!==""}function r_(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function o_(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var l1=/^[ \t]*#include +<([\w\d./]+)>/gm;function hd(n){return n.replace(l1,h1)}var c1=new Map;function h1(n,e){let t=ht[e];if(t===void 0){let i=c1.get(e);if(i!==void 0)t=ht[i],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,i);else throw new Error("Can not resolve #include <"+e+">")}return hd(t)}var u1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function a_(n){return n.replace(u1,f1)}function f1(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function l_(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}function d1(n){let e="SHADOWMAP_TYPE_BASIC";return n.shadowMapType===Ff?e="SHADOWMAP_TYPE_PCF":n.shadowMapType===Jg?e="SHADOWMAP_TYPE_PCF_SOFT":n.shadowMapType===ki&&(e="SHADOWMAP_TYPE_VSM"),e}function p1(n){let e="ENVMAP_TYPE_CUBE";if(n.envMap)switch(n.envMapMode){case xr:case vr:e="ENVMAP_TYPE_CUBE";break;case Oa:e="ENVMAP_TYPE_CUBE_UV";break}return e}function m1(n){let e="ENVMAP_MODE_REFLECTION";if(n.envMap)switch(n.envMapMode){case vr:e="ENVMAP_MODE_REFRACTION";break}return e}function g1(n){let e="ENVMAP_BLENDING_NONE";if(n.envMap)switch(n.combine){case Bf:e="ENVMAP_BLENDING_MULTIPLY";break;case m0:e="ENVMAP_BLENDING_MIX";break;case g0:e="ENVMAP_BLENDING_ADD";break}return e}function _1(n){let e=n.envMapCubeUVHeight;if(e===null)return null;let t=Math.log2(e)-2,i=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:i,maxMip:t}}function x1(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=d1(t),c=p1(t),u=m1(t),h=g1(t),f=_1(t),d=r1(t),_=o1(r),v=s.createProgram(),m,p,T=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(qa).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_].filter(qa).join(`
`),p.length>0&&(p+=`
`)):(m=[l_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",t.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(qa).join(`
`),p=[l_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,_,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor||t.batchingColor?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",t.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ls?"#define TONE_MAPPING":"",t.toneMapping!==ls?ht.tonemapping_pars_fragment:"",t.toneMapping!==ls?i1("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,n1("linearToOutputTexel",t.outputColorSpace),s1(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(qa).join(`
`)),o=hd(o),o=r_(o,t),o=o_(o,t),a=hd(a),a=r_(a,t),a=o_(a,t),o=a_(o),a=a_(a),t.isRawShaderMaterial!==!0&&(T=`#version 300 es
`,m=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",t.glslVersion===To?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===To?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let S=T+m+o,b=T+p+a,N=n_(s,s.VERTEX_SHADER,S),L=n_(s,s.FRAGMENT_SHADER,b);s.attachShader(v,N),s.attachShader(v,L),t.index0AttributeName!==void 0?s.bindAttribLocation(v,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function D(I){if(n.debug.checkShaderErrors){let q=s.getProgramInfoLog(v).trim(),z=s.getShaderInfoLog(N).trim(),W=s.getShaderInfoLog(L).trim(),Y=!0,$=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(Y=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,v,N,L);else{let j=s_(s,N,"vertex"),Q=s_(s,L,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+q+`
`+j+`
`+Q)}else q!==""?console.warn("THREE.WebGLProgram: Program Info Log:",q):(z===""||W==="")&&($=!1);$&&(I.diagnostics={runnable:Y,programLog:q,vertexShader:{log:z,prefix:m},fragmentShader:{log:W,prefix:p}})}s.deleteShader(N),s.deleteShader(L),B=new Ro(s,v),E=a1(s,v)}let B;this.getUniforms=function(){return B===void 0&&D(this),B};let E;this.getAttributes=function(){return E===void 0&&D(this),E};let M=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return M===!1&&(M=s.getProgramParameter(v,jS)),M},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=QS++,this.cacheKey=e,this.usedTimes=1,this.program=v,this.vertexShader=N,this.fragmentShader=L,this}var v1=0,ud=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){let t=e.vertexShader,i=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(i),o=this._getShaderCacheForMaterial(e);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new fd(e),t.set(e,i)),i}},fd=class{constructor(e){this.id=v1++,this.code=e,this.usedTimes=0}};function y1(n,e,t,i,s,r,o){let a=new Aa,l=new ud,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures,d=s.precision,_={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(E){return c.add(E),E===0?"uv":`uv${E}`}function m(E,M,I,q,z){let W=q.fog,Y=z.geometry,$=E.isMeshStandardMaterial?q.environment:null,j=(E.isMeshStandardMaterial?t:e).get(E.envMap||$),Q=j&&j.mapping===Oa?j.image.height:null,he=_[E.type];E.precision!==null&&(d=s.getMaxPrecision(E.precision),d!==E.precision&&console.warn("THREE.WebGLProgram.getParameters:",E.precision,"not supported, using",d,"instead."));let ce=Y.morphAttributes.position||Y.morphAttributes.normal||Y.morphAttributes.color,_e=ce!==void 0?ce.length:0,Se=0;Y.morphAttributes.position!==void 0&&(Se=1),Y.morphAttributes.normal!==void 0&&(Se=2),Y.morphAttributes.color!==void 0&&(Se=3);let me,ee,ue,ve;if(he){let St=Bi[he];me=St.vertexShader,ee=St.fragmentShader}else me=E.vertexShader,ee=E.fragmentShader,l.update(E),ue=l.getVertexShaderID(E),ve=l.getFragmentShaderID(E);let ae=n.getRenderTarget(),Ne=n.state.buffers.depth.getReversed(),tt=z.isInstancedMesh===!0,Ce=z.isBatchedMesh===!0,_t=!!E.map,xt=!!E.matcap,st=!!j,F=!!E.aoMap,Kt=!!E.lightMap,ut=!!E.bumpMap,vt=!!E.normalMap,ze=!!E.displacementMap,at=!!E.emissiveMap,De=!!E.metalnessMap,et=!!E.roughnessMap,It=E.anisotropy>0,P=E.clearcoat>0,x=E.dispersion>0,U=E.iridescence>0,J=E.sheen>0,ne=E.transmission>0,te=It&&!!E.anisotropyMap,Oe=P&&!!E.clearcoatMap,ge=P&&!!E.clearcoatNormalMap,Ue=P&&!!E.clearcoatRoughnessMap,Re=U&&!!E.iridescenceMap,se=U&&!!E.iridescenceThicknessMap,ye=J&&!!E.sheenColorMap,Ge=J&&!!E.sheenRoughnessMap,qe=!!E.specularMap,be=!!E.specularColorMap,Ye=!!E.specularIntensityMap,k=ne&&!!E.transmissionMap,Me=ne&&!!E.thicknessMap,oe=!!E.gradientMap,Fe=!!E.alphaMap,fe=E.alphaTest>0,re=!!E.alphaHash,Be=!!E.extensions,nt=ls;E.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&(nt=n.toneMapping);let Ut={shaderID:he,shaderType:E.type,shaderName:E.name,vertexShader:me,fragmentShader:ee,defines:E.defines,customVertexShaderID:ue,customFragmentShaderID:ve,isRawShaderMaterial:E.isRawShaderMaterial===!0,glslVersion:E.glslVersion,precision:d,batching:Ce,batchingColor:Ce&&z._colorsTexture!==null,instancing:tt,instancingColor:tt&&z.instanceColor!==null,instancingMorph:tt&&z.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:ae===null?n.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:pr,alphaToCoverage:!!E.alphaToCoverage,map:_t,matcap:xt,envMap:st,envMapMode:st&&j.mapping,envMapCubeUVHeight:Q,aoMap:F,lightMap:Kt,bumpMap:ut,normalMap:vt,displacementMap:f&&ze,emissiveMap:at,normalMapObjectSpace:vt&&E.normalMapType===C0,normalMapTangentSpace:vt&&E.normalMapType===A0,metalnessMap:De,roughnessMap:et,anisotropy:It,anisotropyMap:te,clearcoat:P,clearcoatMap:Oe,clearcoatNormalMap:ge,clearcoatRoughnessMap:Ue,dispersion:x,iridescence:U,iridescenceMap:Re,iridescenceThicknessMap:se,sheen:J,sheenColorMap:ye,sheenRoughnessMap:Ge,specularMap:qe,specularColorMap:be,specularIntensityMap:Ye,transmission:ne,transmissionMap:k,thicknessMap:Me,gradientMap:oe,opaque:E.transparent===!1&&E.blending===fr&&E.alphaToCoverage===!1,alphaMap:Fe,alphaTest:fe,alphaHash:re,combine:E.combine,mapUv:_t&&v(E.map.channel),aoMapUv:F&&v(E.aoMap.channel),lightMapUv:Kt&&v(E.lightMap.channel),bumpMapUv:ut&&v(E.bumpMap.channel),normalMapUv:vt&&v(E.normalMap.channel),displacementMapUv:ze&&v(E.displacementMap.channel),emissiveMapUv:at&&v(E.emissiveMap.channel),metalnessMapUv:De&&v(E.metalnessMap.channel),roughnessMapUv:et&&v(E.roughnessMap.channel),anisotropyMapUv:te&&v(E.anisotropyMap.channel),clearcoatMapUv:Oe&&v(E.clearcoatMap.channel),clearcoatNormalMapUv:ge&&v(E.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Ue&&v(E.clearcoatRoughnessMap.channel),iridescenceMapUv:Re&&v(E.iridescenceMap.channel),iridescenceThicknessMapUv:se&&v(E.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&v(E.sheenColorMap.channel),sheenRoughnessMapUv:Ge&&v(E.sheenRoughnessMap.channel),specularMapUv:qe&&v(E.specularMap.channel),specularColorMapUv:be&&v(E.specularColorMap.channel),specularIntensityMapUv:Ye&&v(E.specularIntensityMap.channel),transmissionMapUv:k&&v(E.transmissionMap.channel),thicknessMapUv:Me&&v(E.thicknessMap.channel),alphaMapUv:Fe&&v(E.alphaMap.channel),vertexTangents:!!Y.attributes.tangent&&(vt||It),vertexColors:E.vertexColors,vertexAlphas:E.vertexColors===!0&&!!Y.attributes.color&&Y.attributes.color.itemSize===4,pointsUvs:z.isPoints===!0&&!!Y.attributes.uv&&(_t||Fe),fog:!!W,useFog:E.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:E.flatShading===!0&&E.wireframe===!1,sizeAttenuation:E.sizeAttenuation===!0,logarithmicDepthBuffer:h,reverseDepthBuffer:Ne,skinning:z.isSkinnedMesh===!0,morphTargets:Y.morphAttributes.position!==void 0,morphNormals:Y.morphAttributes.normal!==void 0,morphColors:Y.morphAttributes.color!==void 0,morphTargetsCount:_e,morphTextureStride:Se,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:E.dithering,shadowMapEnabled:n.shadowMap.enabled&&I.length>0,shadowMapType:n.shadowMap.type,toneMapping:nt,decodeVideoTexture:_t&&E.map.isVideoTexture===!0&&mt.getTransfer(E.map.colorSpace)===Pt,decodeVideoTextureEmissive:at&&E.emissiveMap.isVideoTexture===!0&&mt.getTransfer(E.emissiveMap.colorSpace)===Pt,premultipliedAlpha:E.premultipliedAlpha,doubleSided:E.side===Oi,flipSided:E.side===Nn,useDepthPacking:E.depthPacking>=0,depthPacking:E.depthPacking||0,index0AttributeName:E.index0AttributeName,extensionClipCullDistance:Be&&E.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Be&&E.extensions.multiDraw===!0||Ce)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:E.customProgramCacheKey()};return Ut.vertexUv1s=c.has(1),Ut.vertexUv2s=c.has(2),Ut.vertexUv3s=c.has(3),c.clear(),Ut}function p(E){let M=[];if(E.shaderID?M.push(E.shaderID):(M.push(E.customVertexShaderID),M.push(E.customFragmentShaderID)),E.defines!==void 0)for(let I in E.defines)M.push(I),M.push(E.defines[I]);return E.isRawShaderMaterial===!1&&(T(M,E),S(M,E),M.push(n.outputColorSpace)),M.push(E.customProgramCacheKey),M.join()}function T(E,M){E.push(M.precision),E.push(M.outputColorSpace),E.push(M.envMapMode),E.push(M.envMapCubeUVHeight),E.push(M.mapUv),E.push(M.alphaMapUv),E.push(M.lightMapUv),E.push(M.aoMapUv),E.push(M.bumpMapUv),E.push(M.normalMapUv),E.push(M.displacementMapUv),E.push(M.emissiveMapUv),E.push(M.metalnessMapUv),E.push(M.roughnessMapUv),E.push(M.anisotropyMapUv),E.push(M.clearcoatMapUv),E.push(M.clearcoatNormalMapUv),E.push(M.clearcoatRoughnessMapUv),E.push(M.iridescenceMapUv),E.push(M.iridescenceThicknessMapUv),E.push(M.sheenColorMapUv),E.push(M.sheenRoughnessMapUv),E.push(M.specularMapUv),E.push(M.specularColorMapUv),E.push(M.specularIntensityMapUv),E.push(M.transmissionMapUv),E.push(M.thicknessMapUv),E.push(M.combine),E.push(M.fogExp2),E.push(M.sizeAttenuation),E.push(M.morphTargetsCount),E.push(M.morphAttributeCount),E.push(M.numDirLights),E.push(M.numPointLights),E.push(M.numSpotLights),E.push(M.numSpotLightMaps),E.push(M.numHemiLights),E.push(M.numRectAreaLights),E.push(M.numDirLightShadows),E.push(M.numPointLightShadows),E.push(M.numSpotLightShadows),E.push(M.numSpotLightShadowsWithMaps),E.push(M.numLightProbes),E.push(M.shadowMapType),E.push(M.toneMapping),E.push(M.numClippingPlanes),E.push(M.numClipIntersection),E.push(M.depthPacking)}function S(E,M){a.disableAll(),M.supportsVertexTextures&&a.enable(0),M.instancing&&a.enable(1),M.instancingColor&&a.enable(2),M.instancingMorph&&a.enable(3),M.matcap&&a.enable(4),M.envMap&&a.enable(5),M.normalMapObjectSpace&&a.enable(6),M.normalMapTangentSpace&&a.enable(7),M.clearcoat&&a.enable(8),M.iridescence&&a.enable(9),M.alphaTest&&a.enable(10),M.vertexColors&&a.enable(11),M.vertexAlphas&&a.enable(12),M.vertexUv1s&&a.enable(13),M.vertexUv2s&&a.enable(14),M.vertexUv3s&&a.enable(15),M.vertexTangents&&a.enable(16),M.anisotropy&&a.enable(17),M.alphaHash&&a.enable(18),M.batching&&a.enable(19),M.dispersion&&a.enable(20),M.batchingColor&&a.enable(21),M.gradientMap&&a.enable(22),E.push(a.mask),a.disableAll(),M.fog&&a.enable(0),M.useFog&&a.enable(1),M.flatShading&&a.enable(2),M.logarithmicDepthBuffer&&a.enable(3),M.reverseDepthBuffer&&a.enable(4),M.skinning&&a.enable(5),M.morphTargets&&a.enable(6),M.morphNormals&&a.enable(7),M.morphColors&&a.enable(8),M.premultipliedAlpha&&a.enable(9),M.shadowMapEnabled&&a.enable(10),M.doubleSided&&a.enable(11),M.flipSided&&a.enable(12),M.useDepthPacking&&a.enable(13),M.dithering&&a.enable(14),M.transmission&&a.enable(15),M.sheen&&a.enable(16),M.opaque&&a.enable(17),M.pointsUvs&&a.enable(18),M.decodeVideoTexture&&a.enable(19),M.decodeVideoTextureEmissive&&a.enable(20),M.alphaToCoverage&&a.enable(21),E.push(a.mask)}function b(E){let M=_[E.type],I;if(M){let q=Bi[M];I=V0.clone(q.uniforms)}else I=E.uniforms;return I}function N(E,M){let I;for(let q=0,z=u.length;q<z;q++){let W=u[q];if(W.cacheKey===M){I=W,++I.usedTimes;break}}return I===void 0&&(I=new x1(n,M,E,r),u.push(I)),I}function L(E){if(--E.usedTimes===0){let M=u.indexOf(E);u[M]=u[u.length-1],u.pop(),E.destroy()}}function D(E){l.remove(E)}function B(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:b,acquireProgram:N,releaseProgram:L,releaseShaderCache:D,programs:u,dispose:B}}function b1(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function M1(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.z!==e.z?n.z-e.z:n.id-e.id}function c_(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function h_(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h,f,d,_,v,m){let p=n[e];return p===void 0?(p={id:h.id,object:h,geometry:f,material:d,groupOrder:_,renderOrder:h.renderOrder,z:v,group:m},n[e]=p):(p.id=h.id,p.object=h,p.geometry=f,p.material=d,p.groupOrder=_,p.renderOrder=h.renderOrder,p.z=v,p.group=m),e++,p}function a(h,f,d,_,v,m){let p=o(h,f,d,_,v,m);d.transmission>0?i.push(p):d.transparent===!0?s.push(p):t.push(p)}function l(h,f,d,_,v,m){let p=o(h,f,d,_,v,m);d.transmission>0?i.unshift(p):d.transparent===!0?s.unshift(p):t.unshift(p)}function c(h,f){t.length>1&&t.sort(h||M1),i.length>1&&i.sort(f||c_),s.length>1&&s.sort(f||c_)}function u(){for(let h=e,f=n.length;h<f;h++){let d=n[h];if(d.id===null)break;d.id=null,d.object=null,d.geometry=null,d.material=null,d.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function w1(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new h_,n.set(i,[o])):s>=r.length?(o=new h_,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function S1(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new K,color:new At};break;case"SpotLight":t={position:new K,direction:new K,color:new At,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new K,color:new At,distance:0,decay:0};break;case"HemisphereLight":t={direction:new K,skyColor:new At,groundColor:new At};break;case"RectAreaLight":t={color:new At,position:new K,halfWidth:new K,halfHeight:new K};break}return n[e.id]=t,t}}}function E1(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Lt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Lt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Lt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var T1=0;function A1(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function C1(n){let e=new S1,t=E1(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new K);let s=new K,r=new on,o=new on;function a(c){let u=0,h=0,f=0;for(let E=0;E<9;E++)i.probe[E].set(0,0,0);let d=0,_=0,v=0,m=0,p=0,T=0,S=0,b=0,N=0,L=0,D=0;c.sort(A1);for(let E=0,M=c.length;E<M;E++){let I=c[E],q=I.color,z=I.intensity,W=I.distance,Y=I.shadow&&I.shadow.map?I.shadow.map.texture:null;if(I.isAmbientLight)u+=q.r*z,h+=q.g*z,f+=q.b*z;else if(I.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(I.sh.coefficients[$],z);D++}else if(I.isDirectionalLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let j=I.shadow,Q=t.get(I);Q.shadowIntensity=j.intensity,Q.shadowBias=j.bias,Q.shadowNormalBias=j.normalBias,Q.shadowRadius=j.radius,Q.shadowMapSize=j.mapSize,i.directionalShadow[d]=Q,i.directionalShadowMap[d]=Y,i.directionalShadowMatrix[d]=I.shadow.matrix,T++}i.directional[d]=$,d++}else if(I.isSpotLight){let $=e.get(I);$.position.setFromMatrixPosition(I.matrixWorld),$.color.copy(q).multiplyScalar(z),$.distance=W,$.coneCos=Math.cos(I.angle),$.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),$.decay=I.decay,i.spot[v]=$;let j=I.shadow;if(I.map&&(i.spotLightMap[N]=I.map,N++,j.updateMatrices(I),I.castShadow&&L++),i.spotLightMatrix[v]=j.matrix,I.castShadow){let Q=t.get(I);Q.shadowIntensity=j.intensity,Q.shadowBias=j.bias,Q.shadowNormalBias=j.normalBias,Q.shadowRadius=j.radius,Q.shadowMapSize=j.mapSize,i.spotShadow[v]=Q,i.spotShadowMap[v]=Y,b++}v++}else if(I.isRectAreaLight){let $=e.get(I);$.color.copy(q).multiplyScalar(z),$.halfWidth.set(I.width*.5,0,0),$.halfHeight.set(0,I.height*.5,0),i.rectArea[m]=$,m++}else if(I.isPointLight){let $=e.get(I);if($.color.copy(I.color).multiplyScalar(I.intensity),$.distance=I.distance,$.decay=I.decay,I.castShadow){let j=I.shadow,Q=t.get(I);Q.shadowIntensity=j.intensity,Q.shadowBias=j.bias,Q.shadowNormalBias=j.normalBias,Q.shadowRadius=j.radius,Q.shadowMapSize=j.mapSize,Q.shadowCameraNear=j.camera.near,Q.shadowCameraFar=j.camera.far,i.pointShadow[_]=Q,i.pointShadowMap[_]=Y,i.pointShadowMatrix[_]=I.shadow.matrix,S++}i.point[_]=$,_++}else if(I.isHemisphereLight){let $=e.get(I);$.skyColor.copy(I.color).multiplyScalar(z),$.groundColor.copy(I.groundColor).multiplyScalar(z),i.hemi[p]=$,p++}}m>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ee.LTC_FLOAT_1,i.rectAreaLTC2=Ee.LTC_FLOAT_2):(i.rectAreaLTC1=Ee.LTC_HALF_1,i.rectAreaLTC2=Ee.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let B=i.hash;(B.directionalLength!==d||B.pointLength!==_||B.spotLength!==v||B.rectAreaLength!==m||B.hemiLength!==p||B.numDirectionalShadows!==T||B.numPointShadows!==S||B.numSpotShadows!==b||B.numSpotMaps!==N||B.numLightProbes!==D)&&(i.directional.length=d,i.spot.length=v,i.rectArea.length=m,i.point.length=_,i.hemi.length=p,i.directionalShadow.length=T,i.directionalShadowMap.length=T,i.pointShadow.length=S,i.pointShadowMap.length=S,i.spotShadow.length=b,i.spotShadowMap.length=b,i.directionalShadowMatrix.length=T,i.pointShadowMatrix.length=S,i.spotLightMatrix.length=b+N-L,i.spotLightMap.length=N,i.numSpotLightShadowsWithMaps=L,i.numLightProbes=D,B.directionalLength=d,B.pointLength=_,B.spotLength=v,B.rectAreaLength=m,B.hemiLength=p,B.numDirectionalShadows=T,B.numPointShadows=S,B.numSpotShadows=b,B.numSpotMaps=N,B.numLightProbes=D,i.version=T1++)}function l(c,u){let h=0,f=0,d=0,_=0,v=0,m=u.matrixWorldInverse;for(let p=0,T=c.length;p<T;p++){let S=c[p];if(S.isDirectionalLight){let b=i.directional[h];b.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),b.direction.sub(s),b.direction.transformDirection(m),h++}else if(S.isSpotLight){let b=i.spot[d];b.position.setFromMatrixPosition(S.matrixWorld),b.position.applyMatrix4(m),b.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),b.direction.sub(s),b.direction.transformDirection(m),d++}else if(S.isRectAreaLight){let b=i.rectArea[_];b.position.setFromMatrixPosition(S.matrixWorld),b.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),b.halfWidth.set(S.width*.5,0,0),b.halfHeight.set(0,S.height*.5,0),b.halfWidth.applyMatrix4(o),b.halfHeight.applyMatrix4(o),_++}else if(S.isPointLight){let b=i.point[f];b.position.setFromMatrixPosition(S.matrixWorld),b.position.applyMatrix4(m),f++}else if(S.isHemisphereLight){let b=i.hemi[v];b.direction.setFromMatrixPosition(S.matrixWorld),b.direction.transformDirection(m),v++}}}return{setup:a,setupView:l,state:i}}function u_(n){let e=new C1(n),t=[],i=[];function s(u){c.camera=u,t.length=0,i.length=0}function r(u){t.push(u)}function o(u){i.push(u)}function a(){e.setup(t)}function l(u){e.setupView(t,u)}let c={lightsArray:t,shadowsArray:i,camera:null,lights:e,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function R1(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new u_(n),e.set(s,[a])):r>=o.length?(a=new u_(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var I1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,P1=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function L1(n,e,t){let i=new Ua,s=new Lt,r=new Lt,o=new Yt,a=new Mc({depthPacking:T0}),l=new wc,c={},u=t.maxTextureSize,h={[ss]:Nn,[Nn]:ss,[Oi]:Oi},f=new mi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Lt},radius:{value:4}},vertexShader:I1,fragmentShader:P1}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let _=new pi;_.setAttribute("position",new dn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Fn(_,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ff;let p=this.type;this.render=function(L,D,B){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||L.length===0)return;let E=n.getRenderTarget(),M=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),q=n.state;q.setBlending(as),q.buffers.color.setClear(1,1,1,1),q.buffers.depth.setTest(!0),q.setScissorTest(!1);let z=p!==ki&&this.type===ki,W=p===ki&&this.type!==ki;for(let Y=0,$=L.length;Y<$;Y++){let j=L[Y],Q=j.shadow;if(Q===void 0){console.warn("THREE.WebGLShadowMap:",j,"has no shadow.");continue}if(Q.autoUpdate===!1&&Q.needsUpdate===!1)continue;s.copy(Q.mapSize);let he=Q.getFrameExtents();if(s.multiply(he),r.copy(Q.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/he.x),s.x=r.x*he.x,Q.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/he.y),s.y=r.y*he.y,Q.mapSize.y=r.y)),Q.map===null||z===!0||W===!0){let _e=this.type!==ki?{minFilter:Gn,magFilter:Gn}:{};Q.map!==null&&Q.map.dispose(),Q.map=new Fi(s.x,s.y,_e),Q.map.texture.name=j.name+".shadowMap",Q.camera.updateProjectionMatrix()}n.setRenderTarget(Q.map),n.clear();let ce=Q.getViewportCount();for(let _e=0;_e<ce;_e++){let Se=Q.getViewport(_e);o.set(r.x*Se.x,r.y*Se.y,r.x*Se.z,r.y*Se.w),q.viewport(o),Q.updateMatrices(j,_e),i=Q.getFrustum(),b(D,B,Q.camera,j,this.type)}Q.isPointLightShadow!==!0&&this.type===ki&&T(Q,B),Q.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(E,M,I)};function T(L,D){let B=e.update(v);f.defines.VSM_SAMPLES!==L.blurSamples&&(f.defines.VSM_SAMPLES=L.blurSamples,d.defines.VSM_SAMPLES=L.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),L.mapPass===null&&(L.mapPass=new Fi(s.x,s.y)),f.uniforms.shadow_pass.value=L.map.texture,f.uniforms.resolution.value=L.mapSize,f.uniforms.radius.value=L.radius,n.setRenderTarget(L.mapPass),n.clear(),n.renderBufferDirect(D,null,B,f,v,null),d.uniforms.shadow_pass.value=L.mapPass.texture,d.uniforms.resolution.value=L.mapSize,d.uniforms.radius.value=L.radius,n.setRenderTarget(L.map),n.clear(),n.renderBufferDirect(D,null,B,d,v,null)}function S(L,D,B,E){let M=null,I=B.isPointLight===!0?L.customDistanceMaterial:L.customDepthMaterial;if(I!==void 0)M=I;else if(M=B.isPointLight===!0?l:a,n.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0||D.alphaToCoverage===!0){let q=M.uuid,z=D.uuid,W=c[q];W===void 0&&(W={},c[q]=W);let Y=W[z];Y===void 0&&(Y=M.clone(),W[z]=Y,D.addEventListener("dispose",N)),M=Y}if(M.visible=D.visible,M.wireframe=D.wireframe,E===ki?M.side=D.shadowSide!==null?D.shadowSide:D.side:M.side=D.shadowSide!==null?D.shadowSide:h[D.side],M.alphaMap=D.alphaMap,M.alphaTest=D.alphaToCoverage===!0?.5:D.alphaTest,M.map=D.map,M.clipShadows=D.clipShadows,M.clippingPlanes=D.clippingPlanes,M.clipIntersection=D.clipIntersection,M.displacementMap=D.displacementMap,M.displacementScale=D.displacementScale,M.displacementBias=D.displacementBias,M.wireframeLinewidth=D.wireframeLinewidth,M.linewidth=D.linewidth,B.isPointLight===!0&&M.isMeshDistanceMaterial===!0){let q=n.properties.get(M);q.light=B}return M}function b(L,D,B,E,M){if(L.visible===!1)return;if(L.layers.test(D.layers)&&(L.isMesh||L.isLine||L.isPoints)&&(L.castShadow||L.receiveShadow&&M===ki)&&(!L.frustumCulled||i.intersectsObject(L))){L.modelViewMatrix.multiplyMatrices(B.matrixWorldInverse,L.matrixWorld);let z=e.update(L),W=L.material;if(Array.isArray(W)){let Y=z.groups;for(let $=0,j=Y.length;$<j;$++){let Q=Y[$],he=W[Q.materialIndex];if(he&&he.visible){let ce=S(L,he,E,M);L.onBeforeShadow(n,L,D,B,z,ce,Q),n.renderBufferDirect(B,null,z,ce,L,Q),L.onAfterShadow(n,L,D,B,z,ce,Q)}}}else if(W.visible){let Y=S(L,W,E,M);L.onBeforeShadow(n,L,D,B,z,Y,null),n.renderBufferDirect(B,null,z,Y,L,null),L.onAfterShadow(n,L,D,B,z,Y,null)}}let q=L.children;for(let z=0,W=q.length;z<W;z++)b(q[z],D,B,E,M)}function N(L){L.target.removeEventListener("dispose",N);for(let B in c){let E=c[B],M=L.target.uuid;M in E&&(E[M].dispose(),delete E[M])}}}var D1={[Uc]:Fc,[Nc]:Bc,[kc]:zc,[dr]:Oc,[Fc]:Uc,[Bc]:Nc,[zc]:kc,[Oc]:dr};function U1(n,e){function t(){let k=!1,Me=new Yt,oe=null,Fe=new Yt(0,0,0,0);return{setMask:function(fe){oe!==fe&&!k&&(n.colorMask(fe,fe,fe,fe),oe=fe)},setLocked:function(fe){k=fe},setClear:function(fe,re,Be,nt,Ut){Ut===!0&&(fe*=nt,re*=nt,Be*=nt),Me.set(fe,re,Be,nt),Fe.equals(Me)===!1&&(n.clearColor(fe,re,Be,nt),Fe.copy(Me))},reset:function(){k=!1,oe=null,Fe.set(-1,0,0,0)}}}function i(){let k=!1,Me=!1,oe=null,Fe=null,fe=null;return{setReversed:function(re){if(Me!==re){let Be=e.get("EXT_clip_control");re?Be.clipControlEXT(Be.LOWER_LEFT_EXT,Be.ZERO_TO_ONE_EXT):Be.clipControlEXT(Be.LOWER_LEFT_EXT,Be.NEGATIVE_ONE_TO_ONE_EXT),Me=re;let nt=fe;fe=null,this.setClear(nt)}},getReversed:function(){return Me},setTest:function(re){re?ae(n.DEPTH_TEST):Ne(n.DEPTH_TEST)},setMask:function(re){oe!==re&&!k&&(n.depthMask(re),oe=re)},setFunc:function(re){if(Me&&(re=D1[re]),Fe!==re){switch(re){case Uc:n.depthFunc(n.NEVER);break;case Fc:n.depthFunc(n.ALWAYS);break;case Nc:n.depthFunc(n.LESS);break;case dr:n.depthFunc(n.LEQUAL);break;case kc:n.depthFunc(n.EQUAL);break;case Oc:n.depthFunc(n.GEQUAL);break;case Bc:n.depthFunc(n.GREATER);break;case zc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Fe=re}},setLocked:function(re){k=re},setClear:function(re){fe!==re&&(Me&&(re=1-re),n.clearDepth(re),fe=re)},reset:function(){k=!1,oe=null,Fe=null,fe=null,Me=!1}}}function s(){let k=!1,Me=null,oe=null,Fe=null,fe=null,re=null,Be=null,nt=null,Ut=null;return{setTest:function(St){k||(St?ae(n.STENCIL_TEST):Ne(n.STENCIL_TEST))},setMask:function(St){Me!==St&&!k&&(n.stencilMask(St),Me=St)},setFunc:function(St,an,Bt){(oe!==St||Fe!==an||fe!==Bt)&&(n.stencilFunc(St,an,Bt),oe=St,Fe=an,fe=Bt)},setOp:function(St,an,Bt){(re!==St||Be!==an||nt!==Bt)&&(n.stencilOp(St,an,Bt),re=St,Be=an,nt=Bt)},setLocked:function(St){k=St},setClear:function(St){Ut!==St&&(n.clearStencil(St),Ut=St)},reset:function(){k=!1,Me=null,oe=null,Fe=null,fe=null,re=null,Be=null,nt=null,Ut=null}}}let r=new t,o=new i,a=new s,l=new WeakMap,c=new WeakMap,u={},h={},f=new WeakMap,d=[],_=null,v=!1,m=null,p=null,T=null,S=null,b=null,N=null,L=null,D=new At(0,0,0),B=0,E=!1,M=null,I=null,q=null,z=null,W=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),$=!1,j=0,Q=n.getParameter(n.VERSION);Q.indexOf("WebGL")!==-1?(j=parseFloat(/^WebGL (\d)/.exec(Q)[1]),$=j>=1):Q.indexOf("OpenGL ES")!==-1&&(j=parseFloat(/^OpenGL ES (\d)/.exec(Q)[1]),$=j>=2);let he=null,ce={},_e=n.getParameter(n.SCISSOR_BOX),Se=n.getParameter(n.VIEWPORT),me=new Yt().fromArray(_e),ee=new Yt().fromArray(Se);function ue(k,Me,oe,Fe){let fe=new Uint8Array(4),re=n.createTexture();n.bindTexture(k,re),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Be=0;Be<oe;Be++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(Me,0,n.RGBA,1,1,Fe,0,n.RGBA,n.UNSIGNED_BYTE,fe):n.texImage2D(Me+Be,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,fe);return re}let ve={};ve[n.TEXTURE_2D]=ue(n.TEXTURE_2D,n.TEXTURE_2D,1),ve[n.TEXTURE_CUBE_MAP]=ue(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ve[n.TEXTURE_2D_ARRAY]=ue(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ve[n.TEXTURE_3D]=ue(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ae(n.DEPTH_TEST),o.setFunc(dr),ut(!1),vt(Uf),ae(n.CULL_FACE),F(as);function ae(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function Ne(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function tt(k,Me){return h[k]!==Me?(n.bindFramebuffer(k,Me),h[k]=Me,k===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=Me),k===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=Me),!0):!1}function Ce(k,Me){let oe=d,Fe=!1;if(k){oe=f.get(Me),oe===void 0&&(oe=[],f.set(Me,oe));let fe=k.textures;if(oe.length!==fe.length||oe[0]!==n.COLOR_ATTACHMENT0){for(let re=0,Be=fe.length;re<Be;re++)oe[re]=n.COLOR_ATTACHMENT0+re;oe.length=fe.length,Fe=!0}}else oe[0]!==n.BACK&&(oe[0]=n.BACK,Fe=!0);Fe&&n.drawBuffers(oe)}function _t(k){return _!==k?(n.useProgram(k),_=k,!0):!1}let xt={[Ls]:n.FUNC_ADD,[jg]:n.FUNC_SUBTRACT,[Qg]:n.FUNC_REVERSE_SUBTRACT};xt[e0]=n.MIN,xt[t0]=n.MAX;let st={[n0]:n.ZERO,[i0]:n.ONE,[s0]:n.SRC_COLOR,[hc]:n.SRC_ALPHA,[h0]:n.SRC_ALPHA_SATURATE,[l0]:n.DST_COLOR,[o0]:n.DST_ALPHA,[r0]:n.ONE_MINUS_SRC_COLOR,[uc]:n.ONE_MINUS_SRC_ALPHA,[c0]:n.ONE_MINUS_DST_COLOR,[a0]:n.ONE_MINUS_DST_ALPHA,[u0]:n.CONSTANT_COLOR,[f0]:n.ONE_MINUS_CONSTANT_COLOR,[d0]:n.CONSTANT_ALPHA,[p0]:n.ONE_MINUS_CONSTANT_ALPHA};function F(k,Me,oe,Fe,fe,re,Be,nt,Ut,St){if(k===as){v===!0&&(Ne(n.BLEND),v=!1);return}if(v===!1&&(ae(n.BLEND),v=!0),k!==Kg){if(k!==m||St!==E){if((p!==Ls||b!==Ls)&&(n.blendEquation(n.FUNC_ADD),p=Ls,b=Ls),St)switch(k){case fr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Nf:n.blendFunc(n.ONE,n.ONE);break;case kf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Of:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",k);break}else switch(k){case fr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Nf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case kf:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Of:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",k);break}T=null,S=null,N=null,L=null,D.set(0,0,0),B=0,m=k,E=St}return}fe=fe||Me,re=re||oe,Be=Be||Fe,(Me!==p||fe!==b)&&(n.blendEquationSeparate(xt[Me],xt[fe]),p=Me,b=fe),(oe!==T||Fe!==S||re!==N||Be!==L)&&(n.blendFuncSeparate(st[oe],st[Fe],st[re],st[Be]),T=oe,S=Fe,N=re,L=Be),(nt.equals(D)===!1||Ut!==B)&&(n.blendColor(nt.r,nt.g,nt.b,Ut),D.copy(nt),B=Ut),m=k,E=!1}function Kt(k,Me){k.side===Oi?Ne(n.CULL_FACE):ae(n.CULL_FACE);let oe=k.side===Nn;Me&&(oe=!oe),ut(oe),k.blending===fr&&k.transparent===!1?F(as):F(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Fe=k.stencilWrite;a.setTest(Fe),Fe&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),at(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?ae(n.SAMPLE_ALPHA_TO_COVERAGE):Ne(n.SAMPLE_ALPHA_TO_COVERAGE)}function ut(k){M!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),M=k)}function vt(k){k!==Yg?(ae(n.CULL_FACE),k!==I&&(k===Uf?n.cullFace(n.BACK):k===Zg?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ne(n.CULL_FACE),I=k}function ze(k){k!==q&&($&&n.lineWidth(k),q=k)}function at(k,Me,oe){k?(ae(n.POLYGON_OFFSET_FILL),(z!==Me||W!==oe)&&(n.polygonOffset(Me,oe),z=Me,W=oe)):Ne(n.POLYGON_OFFSET_FILL)}function De(k){k?ae(n.SCISSOR_TEST):Ne(n.SCISSOR_TEST)}function et(k){k===void 0&&(k=n.TEXTURE0+Y-1),he!==k&&(n.activeTexture(k),he=k)}function It(k,Me,oe){oe===void 0&&(he===null?oe=n.TEXTURE0+Y-1:oe=he);let Fe=ce[oe];Fe===void 0&&(Fe={type:void 0,texture:void 0},ce[oe]=Fe),(Fe.type!==k||Fe.texture!==Me)&&(he!==oe&&(n.activeTexture(oe),he=oe),n.bindTexture(k,Me||ve[k]),Fe.type=k,Fe.texture=Me)}function P(){let k=ce[he];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function x(){try{n.compressedTexImage2D(...arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function U(){try{n.compressedTexImage3D(...arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function J(){try{n.texSubImage2D(...arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function ne(){try{n.texSubImage3D(...arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function te(){try{n.compressedTexSubImage2D(...arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Oe(){try{n.compressedTexSubImage3D(...arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function ge(){try{n.texStorage2D(...arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Ue(){try{n.texStorage3D(...arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Re(){try{n.texImage2D(...arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function se(){try{n.texImage3D(...arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function ye(k){me.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),me.copy(k))}function Ge(k){ee.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),ee.copy(k))}function qe(k,Me){let oe=c.get(Me);oe===void 0&&(oe=new WeakMap,c.set(Me,oe));let Fe=oe.get(k);Fe===void 0&&(Fe=n.getUniformBlockIndex(Me,k.name),oe.set(k,Fe))}function be(k,Me){let Fe=c.get(Me).get(k);l.get(Me)!==Fe&&(n.uniformBlockBinding(Me,Fe,k.__bindingPointIndex),l.set(Me,Fe))}function Ye(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),u={},he=null,ce={},h={},f=new WeakMap,d=[],_=null,v=!1,m=null,p=null,T=null,S=null,b=null,N=null,L=null,D=new At(0,0,0),B=0,E=!1,M=null,I=null,q=null,z=null,W=null,me.set(0,0,n.canvas.width,n.canvas.height),ee.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ae,disable:Ne,bindFramebuffer:tt,drawBuffers:Ce,useProgram:_t,setBlending:F,setMaterial:Kt,setFlipSided:ut,setCullFace:vt,setLineWidth:ze,setPolygonOffset:at,setScissorTest:De,activeTexture:et,bindTexture:It,unbindTexture:P,compressedTexImage2D:x,compressedTexImage3D:U,texImage2D:Re,texImage3D:se,updateUBOMapping:qe,uniformBlockBinding:be,texStorage2D:ge,texStorage3D:Ue,texSubImage2D:J,texSubImage3D:ne,compressedTexSubImage2D:te,compressedTexSubImage3D:Oe,scissor:ye,viewport:Ge,reset:Ye}}function F1(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Lt,u=new WeakMap,h,f=new WeakMap,d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(P,x){return d?new OffscreenCanvas(P,x):Ea("canvas")}function v(P,x,U){let J=1,ne=It(P);if((ne.width>U||ne.height>U)&&(J=U/Math.max(ne.width,ne.height)),J<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let te=Math.floor(J*ne.width),Oe=Math.floor(J*ne.height);h===void 0&&(h=_(te,Oe));let ge=x?_(te,Oe):h;return ge.width=te,ge.height=Oe,ge.getContext("2d").drawImage(P,0,0,te,Oe),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+ne.width+"x"+ne.height+") to ("+te+"x"+Oe+")."),ge}else return"data"in P&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+ne.width+"x"+ne.height+")."),P;return P}function m(P){return P.generateMipmaps}function p(P){n.generateMipmap(P)}function T(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function S(P,x,U,J,ne=!1){if(P!==null){if(n[P]!==void 0)return n[P];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let te=x;if(x===n.RED&&(U===n.FLOAT&&(te=n.R32F),U===n.HALF_FLOAT&&(te=n.R16F),U===n.UNSIGNED_BYTE&&(te=n.R8)),x===n.RED_INTEGER&&(U===n.UNSIGNED_BYTE&&(te=n.R8UI),U===n.UNSIGNED_SHORT&&(te=n.R16UI),U===n.UNSIGNED_INT&&(te=n.R32UI),U===n.BYTE&&(te=n.R8I),U===n.SHORT&&(te=n.R16I),U===n.INT&&(te=n.R32I)),x===n.RG&&(U===n.FLOAT&&(te=n.RG32F),U===n.HALF_FLOAT&&(te=n.RG16F),U===n.UNSIGNED_BYTE&&(te=n.RG8)),x===n.RG_INTEGER&&(U===n.UNSIGNED_BYTE&&(te=n.RG8UI),U===n.UNSIGNED_SHORT&&(te=n.RG16UI),U===n.UNSIGNED_INT&&(te=n.RG32UI),U===n.BYTE&&(te=n.RG8I),U===n.SHORT&&(te=n.RG16I),U===n.INT&&(te=n.RG32I)),x===n.RGB_INTEGER&&(U===n.UNSIGNED_BYTE&&(te=n.RGB8UI),U===n.UNSIGNED_SHORT&&(te=n.RGB16UI),U===n.UNSIGNED_INT&&(te=n.RGB32UI),U===n.BYTE&&(te=n.RGB8I),U===n.SHORT&&(te=n.RGB16I),U===n.INT&&(te=n.RGB32I)),x===n.RGBA_INTEGER&&(U===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),U===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),U===n.UNSIGNED_INT&&(te=n.RGBA32UI),U===n.BYTE&&(te=n.RGBA8I),U===n.SHORT&&(te=n.RGBA16I),U===n.INT&&(te=n.RGBA32I)),x===n.RGB&&U===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),x===n.RGBA){let Oe=ne?wa:mt.getTransfer(J);U===n.FLOAT&&(te=n.RGBA32F),U===n.HALF_FLOAT&&(te=n.RGBA16F),U===n.UNSIGNED_BYTE&&(te=Oe===Pt?n.SRGB8_ALPHA8:n.RGBA8),U===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),U===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function b(P,x){let U;return P?x===null||x===ks||x===So?U=n.DEPTH24_STENCIL8:x===oi?U=n.DEPTH32F_STENCIL8:x===Mo&&(U=n.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===ks||x===So?U=n.DEPTH_COMPONENT24:x===oi?U=n.DEPTH_COMPONENT32F:x===Mo&&(U=n.DEPTH_COMPONENT16),U}function N(P,x){return m(P)===!0||P.isFramebufferTexture&&P.minFilter!==Gn&&P.minFilter!==ii?Math.log2(Math.max(x.width,x.height))+1:P.mipmaps!==void 0&&P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?x.mipmaps.length:1}function L(P){let x=P.target;x.removeEventListener("dispose",L),B(x),x.isVideoTexture&&u.delete(x)}function D(P){let x=P.target;x.removeEventListener("dispose",D),M(x)}function B(P){let x=i.get(P);if(x.__webglInit===void 0)return;let U=P.source,J=f.get(U);if(J){let ne=J[x.__cacheKey];ne.usedTimes--,ne.usedTimes===0&&E(P),Object.keys(J).length===0&&f.delete(U)}i.remove(P)}function E(P){let x=i.get(P);n.deleteTexture(x.__webglTexture);let U=P.source,J=f.get(U);delete J[x.__cacheKey],o.memory.textures--}function M(P){let x=i.get(P);if(P.depthTexture&&(P.depthTexture.dispose(),i.remove(P.depthTexture)),P.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(x.__webglFramebuffer[J]))for(let ne=0;ne<x.__webglFramebuffer[J].length;ne++)n.deleteFramebuffer(x.__webglFramebuffer[J][ne]);else n.deleteFramebuffer(x.__webglFramebuffer[J]);x.__webglDepthbuffer&&n.deleteRenderbuffer(x.__webglDepthbuffer[J])}else{if(Array.isArray(x.__webglFramebuffer))for(let J=0;J<x.__webglFramebuffer.length;J++)n.deleteFramebuffer(x.__webglFramebuffer[J]);else n.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&n.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&n.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let J=0;J<x.__webglColorRenderbuffer.length;J++)x.__webglColorRenderbuffer[J]&&n.deleteRenderbuffer(x.__webglColorRenderbuffer[J]);x.__webglDepthRenderbuffer&&n.deleteRenderbuffer(x.__webglDepthRenderbuffer)}let U=P.textures;for(let J=0,ne=U.length;J<ne;J++){let te=i.get(U[J]);te.__webglTexture&&(n.deleteTexture(te.__webglTexture),o.memory.textures--),i.remove(U[J])}i.remove(P)}let I=0;function q(){I=0}function z(){let P=I;return P>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+P+" texture units while this GPU supports only "+s.maxTextures),I+=1,P}function W(P){let x=[];return x.push(P.wrapS),x.push(P.wrapT),x.push(P.wrapR||0),x.push(P.magFilter),x.push(P.minFilter),x.push(P.anisotropy),x.push(P.internalFormat),x.push(P.format),x.push(P.type),x.push(P.generateMipmaps),x.push(P.premultiplyAlpha),x.push(P.flipY),x.push(P.unpackAlignment),x.push(P.colorSpace),x.join()}function Y(P,x){let U=i.get(P);if(P.isVideoTexture&&De(P),P.isRenderTargetTexture===!1&&P.version>0&&U.__version!==P.version){let J=P.image;if(J===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(J.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{ve(U,P,x);return}}t.bindTexture(n.TEXTURE_2D,U.__webglTexture,n.TEXTURE0+x)}function $(P,x){let U=i.get(P);if(P.version>0&&U.__version!==P.version){ve(U,P,x);return}t.bindTexture(n.TEXTURE_2D_ARRAY,U.__webglTexture,n.TEXTURE0+x)}function j(P,x){let U=i.get(P);if(P.version>0&&U.__version!==P.version){ve(U,P,x);return}t.bindTexture(n.TEXTURE_3D,U.__webglTexture,n.TEXTURE0+x)}function Q(P,x){let U=i.get(P);if(P.version>0&&U.__version!==P.version){ae(U,P,x);return}t.bindTexture(n.TEXTURE_CUBE_MAP,U.__webglTexture,n.TEXTURE0+x)}let he={[fc]:n.REPEAT,[Ps]:n.CLAMP_TO_EDGE,[dc]:n.MIRRORED_REPEAT},ce={[Gn]:n.NEAREST,[S0]:n.NEAREST_MIPMAP_NEAREST,[Ba]:n.NEAREST_MIPMAP_LINEAR,[ii]:n.LINEAR,[Gc]:n.LINEAR_MIPMAP_NEAREST,[Ns]:n.LINEAR_MIPMAP_LINEAR},_e={[R0]:n.NEVER,[F0]:n.ALWAYS,[I0]:n.LESS,[Zf]:n.LEQUAL,[P0]:n.EQUAL,[U0]:n.GEQUAL,[L0]:n.GREATER,[D0]:n.NOTEQUAL};function Se(P,x){if(x.type===oi&&e.has("OES_texture_float_linear")===!1&&(x.magFilter===ii||x.magFilter===Gc||x.magFilter===Ba||x.magFilter===Ns||x.minFilter===ii||x.minFilter===Gc||x.minFilter===Ba||x.minFilter===Ns)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,he[x.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,he[x.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,he[x.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,ce[x.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,ce[x.minFilter]),x.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,_e[x.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===Gn||x.minFilter!==Ba&&x.minFilter!==Ns||x.type===oi&&e.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||i.get(x).__currentAnisotropy){let U=e.get("EXT_texture_filter_anisotropic");n.texParameterf(P,U.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(x.anisotropy,s.getMaxAnisotropy())),i.get(x).__currentAnisotropy=x.anisotropy}}}function me(P,x){let U=!1;P.__webglInit===void 0&&(P.__webglInit=!0,x.addEventListener("dispose",L));let J=x.source,ne=f.get(J);ne===void 0&&(ne={},f.set(J,ne));let te=W(x);if(te!==P.__cacheKey){ne[te]===void 0&&(ne[te]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,U=!0),ne[te].usedTimes++;let Oe=ne[P.__cacheKey];Oe!==void 0&&(ne[P.__cacheKey].usedTimes--,Oe.usedTimes===0&&E(x)),P.__cacheKey=te,P.__webglTexture=ne[te].texture}return U}function ee(P,x,U){return Math.floor(Math.floor(P/U)/x)}function ue(P,x,U,J){let te=P.updateRanges;if(te.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,x.width,x.height,U,J,x.data);else{te.sort((se,ye)=>se.start-ye.start);let Oe=0;for(let se=1;se<te.length;se++){let ye=te[Oe],Ge=te[se],qe=ye.start+ye.count,be=ee(Ge.start,x.width,4),Ye=ee(ye.start,x.width,4);Ge.start<=qe+1&&be===Ye&&ee(Ge.start+Ge.count-1,x.width,4)===be?ye.count=Math.max(ye.count,Ge.start+Ge.count-ye.start):(++Oe,te[Oe]=Ge)}te.length=Oe+1;let ge=n.getParameter(n.UNPACK_ROW_LENGTH),Ue=n.getParameter(n.UNPACK_SKIP_PIXELS),Re=n.getParameter(n.UNPACK_SKIP_ROWS);n.pixelStorei(n.UNPACK_ROW_LENGTH,x.width);for(let se=0,ye=te.length;se<ye;se++){let Ge=te[se],qe=Math.floor(Ge.start/4),be=Math.ceil(Ge.count/4),Ye=qe%x.width,k=Math.floor(qe/x.width),Me=be,oe=1;n.pixelStorei(n.UNPACK_SKIP_PIXELS,Ye),n.pixelStorei(n.UNPACK_SKIP_ROWS,k),t.texSubImage2D(n.TEXTURE_2D,0,Ye,k,Me,oe,U,J,x.data)}P.clearUpdateRanges(),n.pixelStorei(n.UNPACK_ROW_LENGTH,ge),n.pixelStorei(n.UNPACK_SKIP_PIXELS,Ue),n.pixelStorei(n.UNPACK_SKIP_ROWS,Re)}}function ve(P,x,U){let J=n.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(J=n.TEXTURE_2D_ARRAY),x.isData3DTexture&&(J=n.TEXTURE_3D);let ne=me(P,x),te=x.source;t.bindTexture(J,P.__webglTexture,n.TEXTURE0+U);let Oe=i.get(te);if(te.version!==Oe.__version||ne===!0){t.activeTexture(n.TEXTURE0+U);let ge=mt.getPrimaries(mt.workingColorSpace),Ue=x.colorSpace===cs?null:mt.getPrimaries(x.colorSpace),Re=x.colorSpace===cs||ge===Ue?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,x.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,x.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Re);let se=v(x.image,!1,s.maxTextureSize);se=et(x,se);let ye=r.convert(x.format,x.colorSpace),Ge=r.convert(x.type),qe=S(x.internalFormat,ye,Ge,x.colorSpace,x.isVideoTexture);Se(J,x);let be,Ye=x.mipmaps,k=x.isVideoTexture!==!0,Me=Oe.__version===void 0||ne===!0,oe=te.dataReady,Fe=N(x,se);if(x.isDepthTexture)qe=b(x.format===Eo,x.type),Me&&(k?t.texStorage2D(n.TEXTURE_2D,1,qe,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,qe,se.width,se.height,0,ye,Ge,null));else if(x.isDataTexture)if(Ye.length>0){k&&Me&&t.texStorage2D(n.TEXTURE_2D,Fe,qe,Ye[0].width,Ye[0].height);for(let fe=0,re=Ye.length;fe<re;fe++)be=Ye[fe],k?oe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,be.width,be.height,ye,Ge,be.data):t.texImage2D(n.TEXTURE_2D,fe,qe,be.width,be.height,0,ye,Ge,be.data);x.generateMipmaps=!1}else k?(Me&&t.texStorage2D(n.TEXTURE_2D,Fe,qe,se.width,se.height),oe&&ue(x,se,ye,Ge)):t.texImage2D(n.TEXTURE_2D,0,qe,se.width,se.height,0,ye,Ge,se.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){k&&Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Fe,qe,Ye[0].width,Ye[0].height,se.depth);for(let fe=0,re=Ye.length;fe<re;fe++)if(be=Ye[fe],x.format!==kn)if(ye!==null)if(k){if(oe)if(x.layerUpdates.size>0){let Be=ed(be.width,be.height,x.format,x.type);for(let nt of x.layerUpdates){let Ut=be.data.subarray(nt*Be/be.data.BYTES_PER_ELEMENT,(nt+1)*Be/be.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,nt,be.width,be.height,1,ye,Ut)}x.clearLayerUpdates()}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,0,be.width,be.height,se.depth,ye,be.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,fe,qe,be.width,be.height,se.depth,0,be.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else k?oe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,fe,0,0,0,be.width,be.height,se.depth,ye,Ge,be.data):t.texImage3D(n.TEXTURE_2D_ARRAY,fe,qe,be.width,be.height,se.depth,0,ye,Ge,be.data)}else{k&&Me&&t.texStorage2D(n.TEXTURE_2D,Fe,qe,Ye[0].width,Ye[0].height);for(let fe=0,re=Ye.length;fe<re;fe++)be=Ye[fe],x.format!==kn?ye!==null?k?oe&&t.compressedTexSubImage2D(n.TEXTURE_2D,fe,0,0,be.width,be.height,ye,be.data):t.compressedTexImage2D(n.TEXTURE_2D,fe,qe,be.width,be.height,0,be.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):k?oe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,be.width,be.height,ye,Ge,be.data):t.texImage2D(n.TEXTURE_2D,fe,qe,be.width,be.height,0,ye,Ge,be.data)}else if(x.isDataArrayTexture)if(k){if(Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Fe,qe,se.width,se.height,se.depth),oe)if(x.layerUpdates.size>0){let fe=ed(se.width,se.height,x.format,x.type);for(let re of x.layerUpdates){let Be=se.data.subarray(re*fe/se.data.BYTES_PER_ELEMENT,(re+1)*fe/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,re,se.width,se.height,1,ye,Ge,Be)}x.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,ye,Ge,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,qe,se.width,se.height,se.depth,0,ye,Ge,se.data);else if(x.isData3DTexture)k?(Me&&t.texStorage3D(n.TEXTURE_3D,Fe,qe,se.width,se.height,se.depth),oe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,ye,Ge,se.data)):t.texImage3D(n.TEXTURE_3D,0,qe,se.width,se.height,se.depth,0,ye,Ge,se.data);else if(x.isFramebufferTexture){if(Me)if(k)t.texStorage2D(n.TEXTURE_2D,Fe,qe,se.width,se.height);else{let fe=se.width,re=se.height;for(let Be=0;Be<Fe;Be++)t.texImage2D(n.TEXTURE_2D,Be,qe,fe,re,0,ye,Ge,null),fe>>=1,re>>=1}}else if(Ye.length>0){if(k&&Me){let fe=It(Ye[0]);t.texStorage2D(n.TEXTURE_2D,Fe,qe,fe.width,fe.height)}for(let fe=0,re=Ye.length;fe<re;fe++)be=Ye[fe],k?oe&&t.texSubImage2D(n.TEXTURE_2D,fe,0,0,ye,Ge,be):t.texImage2D(n.TEXTURE_2D,fe,qe,ye,Ge,be);x.generateMipmaps=!1}else if(k){if(Me){let fe=It(se);t.texStorage2D(n.TEXTURE_2D,Fe,qe,fe.width,fe.height)}oe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ye,Ge,se)}else t.texImage2D(n.TEXTURE_2D,0,qe,ye,Ge,se);m(x)&&p(J),Oe.__version=te.version,x.onUpdate&&x.onUpdate(x)}P.__version=x.version}function ae(P,x,U){if(x.image.length!==6)return;let J=me(P,x),ne=x.source;t.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+U);let te=i.get(ne);if(ne.version!==te.__version||J===!0){t.activeTexture(n.TEXTURE0+U);let Oe=mt.getPrimaries(mt.workingColorSpace),ge=x.colorSpace===cs?null:mt.getPrimaries(x.colorSpace),Ue=x.colorSpace===cs||Oe===ge?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,x.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,x.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ue);let Re=x.isCompressedTexture||x.image[0].isCompressedTexture,se=x.image[0]&&x.image[0].isDataTexture,ye=[];for(let re=0;re<6;re++)!Re&&!se?ye[re]=v(x.image[re],!0,s.maxCubemapSize):ye[re]=se?x.image[re].image:x.image[re],ye[re]=et(x,ye[re]);let Ge=ye[0],qe=r.convert(x.format,x.colorSpace),be=r.convert(x.type),Ye=S(x.internalFormat,qe,be,x.colorSpace),k=x.isVideoTexture!==!0,Me=te.__version===void 0||J===!0,oe=ne.dataReady,Fe=N(x,Ge);Se(n.TEXTURE_CUBE_MAP,x);let fe;if(Re){k&&Me&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Fe,Ye,Ge.width,Ge.height);for(let re=0;re<6;re++){fe=ye[re].mipmaps;for(let Be=0;Be<fe.length;Be++){let nt=fe[Be];x.format!==kn?qe!==null?k?oe&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be,0,0,nt.width,nt.height,qe,nt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be,Ye,nt.width,nt.height,0,nt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):k?oe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be,0,0,nt.width,nt.height,qe,be,nt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be,Ye,nt.width,nt.height,0,qe,be,nt.data)}}}else{if(fe=x.mipmaps,k&&Me){fe.length>0&&Fe++;let re=It(ye[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Fe,Ye,re.width,re.height)}for(let re=0;re<6;re++)if(se){k?oe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,0,0,ye[re].width,ye[re].height,qe,be,ye[re].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,Ye,ye[re].width,ye[re].height,0,qe,be,ye[re].data);for(let Be=0;Be<fe.length;Be++){let Ut=fe[Be].image[re].image;k?oe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be+1,0,0,Ut.width,Ut.height,qe,be,Ut.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be+1,Ye,Ut.width,Ut.height,0,qe,be,Ut.data)}}else{k?oe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,0,0,qe,be,ye[re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,0,Ye,qe,be,ye[re]);for(let Be=0;Be<fe.length;Be++){let nt=fe[Be];k?oe&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be+1,0,0,qe,be,nt.image[re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+re,Be+1,Ye,qe,be,nt.image[re])}}}m(x)&&p(n.TEXTURE_CUBE_MAP),te.__version=ne.version,x.onUpdate&&x.onUpdate(x)}P.__version=x.version}function Ne(P,x,U,J,ne,te){let Oe=r.convert(U.format,U.colorSpace),ge=r.convert(U.type),Ue=S(U.internalFormat,Oe,ge,U.colorSpace),Re=i.get(x),se=i.get(U);if(se.__renderTarget=x,!Re.__hasExternalTextures){let ye=Math.max(1,x.width>>te),Ge=Math.max(1,x.height>>te);ne===n.TEXTURE_3D||ne===n.TEXTURE_2D_ARRAY?t.texImage3D(ne,te,Ue,ye,Ge,x.depth,0,Oe,ge,null):t.texImage2D(ne,te,Ue,ye,Ge,0,Oe,ge,null)}t.bindFramebuffer(n.FRAMEBUFFER,P),at(x)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,J,ne,se.__webglTexture,0,ze(x)):(ne===n.TEXTURE_2D||ne>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ne<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,J,ne,se.__webglTexture,te),t.bindFramebuffer(n.FRAMEBUFFER,null)}function tt(P,x,U){if(n.bindRenderbuffer(n.RENDERBUFFER,P),x.depthBuffer){let J=x.depthTexture,ne=J&&J.isDepthTexture?J.type:null,te=b(x.stencilBuffer,ne),Oe=x.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ge=ze(x);at(x)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ge,te,x.width,x.height):U?n.renderbufferStorageMultisample(n.RENDERBUFFER,ge,te,x.width,x.height):n.renderbufferStorage(n.RENDERBUFFER,te,x.width,x.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Oe,n.RENDERBUFFER,P)}else{let J=x.textures;for(let ne=0;ne<J.length;ne++){let te=J[ne],Oe=r.convert(te.format,te.colorSpace),ge=r.convert(te.type),Ue=S(te.internalFormat,Oe,ge,te.colorSpace),Re=ze(x);U&&at(x)===!1?n.renderbufferStorageMultisample(n.RENDERBUFFER,Re,Ue,x.width,x.height):at(x)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Re,Ue,x.width,x.height):n.renderbufferStorage(n.RENDERBUFFER,Ue,x.width,x.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Ce(P,x){if(x&&x.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(t.bindFramebuffer(n.FRAMEBUFFER,P),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let J=i.get(x.depthTexture);J.__renderTarget=x,(!J.__webglTexture||x.depthTexture.image.width!==x.width||x.depthTexture.image.height!==x.height)&&(x.depthTexture.image.width=x.width,x.depthTexture.image.height=x.height,x.depthTexture.needsUpdate=!0),Y(x.depthTexture,0);let ne=J.__webglTexture,te=ze(x);if(x.depthTexture.format===po)at(x)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,ne,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,ne,0);else if(x.depthTexture.format===Eo)at(x)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,ne,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,ne,0);else throw new Error("Unknown depthTexture format")}function _t(P){let x=i.get(P),U=P.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==P.depthTexture){let J=P.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),J){let ne=()=>{delete x.__boundDepthTexture,delete x.__depthDisposeCallback,J.removeEventListener("dispose",ne)};J.addEventListener("dispose",ne),x.__depthDisposeCallback=ne}x.__boundDepthTexture=J}if(P.depthTexture&&!x.__autoAllocateDepthBuffer){if(U)throw new Error("target.depthTexture not supported in Cube render targets");let J=P.texture.mipmaps;J&&J.length>0?Ce(x.__webglFramebuffer[0],P):Ce(x.__webglFramebuffer,P)}else if(U){x.__webglDepthbuffer=[];for(let J=0;J<6;J++)if(t.bindFramebuffer(n.FRAMEBUFFER,x.__webglFramebuffer[J]),x.__webglDepthbuffer[J]===void 0)x.__webglDepthbuffer[J]=n.createRenderbuffer(),tt(x.__webglDepthbuffer[J],P,!1);else{let ne=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,te=x.__webglDepthbuffer[J];n.bindRenderbuffer(n.RENDERBUFFER,te),n.framebufferRenderbuffer(n.FRAMEBUFFER,ne,n.RENDERBUFFER,te)}}else{let J=P.texture.mipmaps;if(J&&J.length>0?t.bindFramebuffer(n.FRAMEBUFFER,x.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=n.createRenderbuffer(),tt(x.__webglDepthbuffer,P,!1);else{let ne=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,te=x.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,te),n.framebufferRenderbuffer(n.FRAMEBUFFER,ne,n.RENDERBUFFER,te)}}t.bindFramebuffer(n.FRAMEBUFFER,null)}function xt(P,x,U){let J=i.get(P);x!==void 0&&Ne(J.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),U!==void 0&&_t(P)}function st(P){let x=P.texture,U=i.get(P),J=i.get(x);P.addEventListener("dispose",D);let ne=P.textures,te=P.isWebGLCubeRenderTarget===!0,Oe=ne.length>1;if(Oe||(J.__webglTexture===void 0&&(J.__webglTexture=n.createTexture()),J.__version=x.version,o.memory.textures++),te){U.__webglFramebuffer=[];for(let ge=0;ge<6;ge++)if(x.mipmaps&&x.mipmaps.length>0){U.__webglFramebuffer[ge]=[];for(let Ue=0;Ue<x.mipmaps.length;Ue++)U.__webglFramebuffer[ge][Ue]=n.createFramebuffer()}else U.__webglFramebuffer[ge]=n.createFramebuffer()}else{if(x.mipmaps&&x.mipmaps.length>0){U.__webglFramebuffer=[];for(let ge=0;ge<x.mipmaps.length;ge++)U.__webglFramebuffer[ge]=n.createFramebuffer()}else U.__webglFramebuffer=n.createFramebuffer();if(Oe)for(let ge=0,Ue=ne.length;ge<Ue;ge++){let Re=i.get(ne[ge]);Re.__webglTexture===void 0&&(Re.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&at(P)===!1){U.__webglMultisampledFramebuffer=n.createFramebuffer(),U.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,U.__webglMultisampledFramebuffer);for(let ge=0;ge<ne.length;ge++){let Ue=ne[ge];U.__webglColorRenderbuffer[ge]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,U.__webglColorRenderbuffer[ge]);let Re=r.convert(Ue.format,Ue.colorSpace),se=r.convert(Ue.type),ye=S(Ue.internalFormat,Re,se,Ue.colorSpace,P.isXRRenderTarget===!0),Ge=ze(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,Ge,ye,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,U.__webglColorRenderbuffer[ge])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(U.__webglDepthRenderbuffer=n.createRenderbuffer(),tt(U.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(te){t.bindTexture(n.TEXTURE_CUBE_MAP,J.__webglTexture),Se(n.TEXTURE_CUBE_MAP,x);for(let ge=0;ge<6;ge++)if(x.mipmaps&&x.mipmaps.length>0)for(let Ue=0;Ue<x.mipmaps.length;Ue++)Ne(U.__webglFramebuffer[ge][Ue],P,x,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,Ue);else Ne(U.__webglFramebuffer[ge],P,x,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0);m(x)&&p(n.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(Oe){for(let ge=0,Ue=ne.length;ge<Ue;ge++){let Re=ne[ge],se=i.get(Re);t.bindTexture(n.TEXTURE_2D,se.__webglTexture),Se(n.TEXTURE_2D,Re),Ne(U.__webglFramebuffer,P,Re,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,0),m(Re)&&p(n.TEXTURE_2D)}t.unbindTexture()}else{let ge=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(ge=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ge,J.__webglTexture),Se(ge,x),x.mipmaps&&x.mipmaps.length>0)for(let Ue=0;Ue<x.mipmaps.length;Ue++)Ne(U.__webglFramebuffer[Ue],P,x,n.COLOR_ATTACHMENT0,ge,Ue);else Ne(U.__webglFramebuffer,P,x,n.COLOR_ATTACHMENT0,ge,0);m(x)&&p(ge),t.unbindTexture()}P.depthBuffer&&_t(P)}function F(P){let x=P.textures;for(let U=0,J=x.length;U<J;U++){let ne=x[U];if(m(ne)){let te=T(P),Oe=i.get(ne).__webglTexture;t.bindTexture(te,Oe),p(te),t.unbindTexture()}}}let Kt=[],ut=[];function vt(P){if(P.samples>0){if(at(P)===!1){let x=P.textures,U=P.width,J=P.height,ne=n.COLOR_BUFFER_BIT,te=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Oe=i.get(P),ge=x.length>1;if(ge)for(let Re=0;Re<x.length;Re++)t.bindFramebuffer(n.FRAMEBUFFER,Oe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Oe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Oe.__webglMultisampledFramebuffer);let Ue=P.texture.mipmaps;Ue&&Ue.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Oe.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Oe.__webglFramebuffer);for(let Re=0;Re<x.length;Re++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(ne|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(ne|=n.STENCIL_BUFFER_BIT)),ge){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Oe.__webglColorRenderbuffer[Re]);let se=i.get(x[Re]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,se,0)}n.blitFramebuffer(0,0,U,J,0,0,U,J,ne,n.NEAREST),l===!0&&(Kt.length=0,ut.length=0,Kt.push(n.COLOR_ATTACHMENT0+Re),P.depthBuffer&&P.resolveDepthBuffer===!1&&(Kt.push(te),ut.push(te),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,ut)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Kt))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ge)for(let Re=0;Re<x.length;Re++){t.bindFramebuffer(n.FRAMEBUFFER,Oe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.RENDERBUFFER,Oe.__webglColorRenderbuffer[Re]);let se=i.get(x[Re]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Oe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+Re,n.TEXTURE_2D,se,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Oe.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.resolveDepthBuffer===!1&&l){let x=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[x])}}}function ze(P){return Math.min(s.maxSamples,P.samples)}function at(P){let x=i.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function De(P){let x=o.render.frame;u.get(P)!==x&&(u.set(P,x),P.update())}function et(P,x){let U=P.colorSpace,J=P.format,ne=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||U!==pr&&U!==cs&&(mt.getTransfer(U)===Pt?(J!==kn||ne!==ri)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",U)),x}function It(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=z,this.resetTextureUnits=q,this.setTexture2D=Y,this.setTexture2DArray=$,this.setTexture3D=j,this.setTextureCube=Q,this.rebindTextures=xt,this.setupRenderTarget=st,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=vt,this.setupDepthRenderbuffer=_t,this.setupFrameBufferTexture=Ne,this.useMultisampledRTT=at}function N1(n,e){function t(i,s=cs){let r,o=mt.getTransfer(s);if(i===ri)return n.UNSIGNED_BYTE;if(i===Xc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===qc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Gf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Vf)return n.BYTE;if(i===Hf)return n.SHORT;if(i===Mo)return n.UNSIGNED_SHORT;if(i===Wc)return n.INT;if(i===ks)return n.UNSIGNED_INT;if(i===oi)return n.FLOAT;if(i===wo)return n.HALF_FLOAT;if(i===Wf)return n.ALPHA;if(i===Xf)return n.RGB;if(i===kn)return n.RGBA;if(i===po)return n.DEPTH_COMPONENT;if(i===Eo)return n.DEPTH_STENCIL;if(i===qf)return n.RED;if(i===$c)return n.RED_INTEGER;if(i===$f)return n.RG;if(i===Yc)return n.RG_INTEGER;if(i===Zc)return n.RGBA_INTEGER;if(i===za||i===Va||i===Ha||i===Ga)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===za)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Va)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ha)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ga)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===za)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Va)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ha)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ga)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Jc||i===Kc||i===jc||i===Qc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Jc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Kc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===jc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Qc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===eh||i===th||i===nh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===eh||i===th)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===nh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(i===ih||i===sh||i===rh||i===oh||i===ah||i===lh||i===ch||i===hh||i===uh||i===fh||i===dh||i===ph||i===mh||i===gh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===ih)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===sh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===rh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===oh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===ah)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===lh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===ch)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===hh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===uh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===fh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===dh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===ph)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===mh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===gh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Wa||i===_h||i===xh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Wa)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===_h)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===xh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Yf||i===vh||i===yh||i===bh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Wa)return r.COMPRESSED_RED_RGTC1_EXT;if(i===vh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===yh)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===bh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===So?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var k1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,O1=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,dd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t,i){if(this.texture===null){let s=new Wn,r=e.properties.get(s);r.__webglTexture=t.texture,(t.depthNear!==i.depthNear||t.depthFar!==i.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=s}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new mi({vertexShader:k1,fragmentShader:O1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Fn(new Na(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},pd=class extends rs{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,_=null,v=new dd,m=t.getContextAttributes(),p=null,T=null,S=[],b=[],N=new Lt,L=null,D=new Hn;D.viewport=new Yt;let B=new Hn;B.viewport=new Yt;let E=[D,B],M=new Dc,I=null,q=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ue=S[ee];return ue===void 0&&(ue=new xo,S[ee]=ue),ue.getTargetRaySpace()},this.getControllerGrip=function(ee){let ue=S[ee];return ue===void 0&&(ue=new xo,S[ee]=ue),ue.getGripSpace()},this.getHand=function(ee){let ue=S[ee];return ue===void 0&&(ue=new xo,S[ee]=ue),ue.getHandSpace()};function z(ee){let ue=b.indexOf(ee.inputSource);if(ue===-1)return;let ve=S[ue];ve!==void 0&&(ve.update(ee.inputSource,ee.frame,c||o),ve.dispatchEvent({type:ee.type,data:ee.inputSource}))}function W(){s.removeEventListener("select",z),s.removeEventListener("selectstart",z),s.removeEventListener("selectend",z),s.removeEventListener("squeeze",z),s.removeEventListener("squeezestart",z),s.removeEventListener("squeezeend",z),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",Y);for(let ee=0;ee<S.length;ee++){let ue=b[ee];ue!==null&&(b[ee]=null,S[ee].disconnect(ue))}I=null,q=null,v.reset(),e.setRenderTarget(p),d=null,f=null,h=null,s=null,T=null,me.stop(),i.isPresenting=!1,e.setPixelRatio(L),e.setSize(N.width,N.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(p=e.getRenderTarget(),s.addEventListener("select",z),s.addEventListener("selectstart",z),s.addEventListener("selectend",z),s.addEventListener("squeeze",z),s.addEventListener("squeezestart",z),s.addEventListener("squeezeend",z),s.addEventListener("end",W),s.addEventListener("inputsourceschange",Y),m.xrCompatible!==!0&&await t.makeXRCompatible(),L=e.getPixelRatio(),e.getSize(N),typeof XRWebGLBinding<"u"&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,ae=null,Ne=null;m.depth&&(Ne=m.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=m.stencil?Eo:po,ae=m.stencil?So:ks);let tt={colorFormat:t.RGBA8,depthFormat:Ne,scaleFactor:r};h=new XRWebGLBinding(s,t),f=h.createProjectionLayer(tt),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),T=new Fi(f.textureWidth,f.textureHeight,{format:kn,type:ri,depthTexture:new Fa(f.textureWidth,f.textureHeight,ae,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:m.stencil,colorSpace:e.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{let ve={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),T=new Fi(d.framebufferWidth,d.framebufferHeight,{format:kn,type:ri,colorSpace:e.outputColorSpace,stencilBuffer:m.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}T.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),me.setContext(s),me.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return v.getDepthTexture()};function Y(ee){for(let ue=0;ue<ee.removed.length;ue++){let ve=ee.removed[ue],ae=b.indexOf(ve);ae>=0&&(b[ae]=null,S[ae].disconnect(ve))}for(let ue=0;ue<ee.added.length;ue++){let ve=ee.added[ue],ae=b.indexOf(ve);if(ae===-1){for(let tt=0;tt<S.length;tt++)if(tt>=b.length){b.push(ve),ae=tt;break}else if(b[tt]===null){b[tt]=ve,ae=tt;break}if(ae===-1)break}let Ne=S[ae];Ne&&Ne.connect(ve)}}let $=new K,j=new K;function Q(ee,ue,ve){$.setFromMatrixPosition(ue.matrixWorld),j.setFromMatrixPosition(ve.matrixWorld);let ae=$.distanceTo(j),Ne=ue.projectionMatrix.elements,tt=ve.projectionMatrix.elements,Ce=Ne[14]/(Ne[10]-1),_t=Ne[14]/(Ne[10]+1),xt=(Ne[9]+1)/Ne[5],st=(Ne[9]-1)/Ne[5],F=(Ne[8]-1)/Ne[0],Kt=(tt[8]+1)/tt[0],ut=Ce*F,vt=Ce*Kt,ze=ae/(-F+Kt),at=ze*-F;if(ue.matrixWorld.decompose(ee.position,ee.quaternion,ee.scale),ee.translateX(at),ee.translateZ(ze),ee.matrixWorld.compose(ee.position,ee.quaternion,ee.scale),ee.matrixWorldInverse.copy(ee.matrixWorld).invert(),Ne[10]===-1)ee.projectionMatrix.copy(ue.projectionMatrix),ee.projectionMatrixInverse.copy(ue.projectionMatrixInverse);else{let De=Ce+ze,et=_t+ze,It=ut-at,P=vt+(ae-at),x=xt*_t/et*De,U=st*_t/et*De;ee.projectionMatrix.makePerspective(It,P,x,U,De,et),ee.projectionMatrixInverse.copy(ee.projectionMatrix).invert()}}function he(ee,ue){ue===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ue.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let ue=ee.near,ve=ee.far;v.texture!==null&&(v.depthNear>0&&(ue=v.depthNear),v.depthFar>0&&(ve=v.depthFar)),M.near=B.near=D.near=ue,M.far=B.far=D.far=ve,(I!==M.near||q!==M.far)&&(s.updateRenderState({depthNear:M.near,depthFar:M.far}),I=M.near,q=M.far),D.layers.mask=ee.layers.mask|2,B.layers.mask=ee.layers.mask|4,M.layers.mask=D.layers.mask|B.layers.mask;let ae=ee.parent,Ne=M.cameras;he(M,ae);for(let tt=0;tt<Ne.length;tt++)he(Ne[tt],ae);Ne.length===2?Q(M,D,B):M.projectionMatrix.copy(D.projectionMatrix),ce(ee,M,ae)};function ce(ee,ue,ve){ve===null?ee.matrix.copy(ue.matrixWorld):(ee.matrix.copy(ve.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ue.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ue.projectionMatrix),ee.projectionMatrixInverse.copy(ue.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=mc*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return M},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(ee){l=ee,f!==null&&(f.fixedFoveation=ee),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=ee)},this.hasDepthSensing=function(){return v.texture!==null},this.getDepthSensingMesh=function(){return v.getMesh(M)};let _e=null;function Se(ee,ue){if(u=ue.getViewerPose(c||o),_=ue,u!==null){let ve=u.views;d!==null&&(e.setRenderTargetFramebuffer(T,d.framebuffer),e.setRenderTarget(T));let ae=!1;ve.length!==M.cameras.length&&(M.cameras.length=0,ae=!0);for(let Ce=0;Ce<ve.length;Ce++){let _t=ve[Ce],xt=null;if(d!==null)xt=d.getViewport(_t);else{let F=h.getViewSubImage(f,_t);xt=F.viewport,Ce===0&&(e.setRenderTargetTextures(T,F.colorTexture,F.depthStencilTexture),e.setRenderTarget(T))}let st=E[Ce];st===void 0&&(st=new Hn,st.layers.enable(Ce),st.viewport=new Yt,E[Ce]=st),st.matrix.fromArray(_t.transform.matrix),st.matrix.decompose(st.position,st.quaternion,st.scale),st.projectionMatrix.fromArray(_t.projectionMatrix),st.projectionMatrixInverse.copy(st.projectionMatrix).invert(),st.viewport.set(xt.x,xt.y,xt.width,xt.height),Ce===0&&(M.matrix.copy(st.matrix),M.matrix.decompose(M.position,M.quaternion,M.scale)),ae===!0&&M.cameras.push(st)}let Ne=s.enabledFeatures;if(Ne&&Ne.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&h){let Ce=h.getDepthInformation(ve[0]);Ce&&Ce.isValid&&Ce.texture&&v.init(e,Ce,s.renderState)}}for(let ve=0;ve<S.length;ve++){let ae=b[ve],Ne=S[ve];ae!==null&&Ne!==void 0&&Ne.update(ae,ue,c||o)}_e&&_e(ee,ue),ue.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ue}),_=null}let me=new f_;me.setAnimationLoop(Se),this.setAnimationLoop=function(ee){_e=ee},this.dispose=function(){}}},Mr=new Ni,B1=new on;function z1(n,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,Kf(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,T,S,b){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),h(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p)):p.isMeshStandardMaterial?(r(m,p),f(m,p),p.isMeshPhysicalMaterial&&d(m,p,b)):p.isMeshMatcapMaterial?(r(m,p),_(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),v(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,T,S):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Nn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Nn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let T=e.get(p),S=T.envMap,b=T.envMapRotation;S&&(m.envMap.value=S,Mr.copy(b),Mr.x*=-1,Mr.y*=-1,Mr.z*=-1,S.isCubeTexture&&S.isRenderTargetTexture===!1&&(Mr.y*=-1,Mr.z*=-1),m.envMapRotation.value.setFromMatrix4(B1.makeRotationFromEuler(Mr)),m.flipEnvMap.value=S.isCubeTexture&&S.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,T,S){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*T,m.scale.value=S*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function h(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function f(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,T){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Nn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=T.texture,m.transmissionSamplerSize.value.set(T.width,T.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function _(m,p){p.matcap&&(m.matcap.value=p.matcap)}function v(m,p){let T=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(T.matrixWorld),m.nearDistance.value=T.shadow.camera.near,m.farDistance.value=T.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function V1(n,e,t,i){let s={},r={},o=[],a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(T,S){let b=S.program;i.uniformBlockBinding(T,b)}function c(T,S){let b=s[T.id];b===void 0&&(_(T),b=u(T),s[T.id]=b,T.addEventListener("dispose",m));let N=S.program;i.updateUBOMapping(T,N);let L=e.render.frame;r[T.id]!==L&&(f(T),r[T.id]=L)}function u(T){let S=h();T.__bindingPointIndex=S;let b=n.createBuffer(),N=T.__size,L=T.usage;return n.bindBuffer(n.UNIFORM_BUFFER,b),n.bufferData(n.UNIFORM_BUFFER,N,L),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,S,b),b}function h(){for(let T=0;T<a;T++)if(o.indexOf(T)===-1)return o.push(T),T;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(T){let S=s[T.id],b=T.uniforms,N=T.__cache;n.bindBuffer(n.UNIFORM_BUFFER,S);for(let L=0,D=b.length;L<D;L++){let B=Array.isArray(b[L])?b[L]:[b[L]];for(let E=0,M=B.length;E<M;E++){let I=B[E];if(d(I,L,E,N)===!0){let q=I.__offset,z=Array.isArray(I.value)?I.value:[I.value],W=0;for(let Y=0;Y<z.length;Y++){let $=z[Y],j=v($);typeof $=="number"||typeof $=="boolean"?(I.__data[0]=$,n.bufferSubData(n.UNIFORM_BUFFER,q+W,I.__data)):$.isMatrix3?(I.__data[0]=$.elements[0],I.__data[1]=$.elements[1],I.__data[2]=$.elements[2],I.__data[3]=0,I.__data[4]=$.elements[3],I.__data[5]=$.elements[4],I.__data[6]=$.elements[5],I.__data[7]=0,I.__data[8]=$.elements[6],I.__data[9]=$.elements[7],I.__data[10]=$.elements[8],I.__data[11]=0):($.toArray(I.__data,W),W+=j.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,q,I.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function d(T,S,b,N){let L=T.value,D=S+"_"+b;if(N[D]===void 0)return typeof L=="number"||typeof L=="boolean"?N[D]=L:N[D]=L.clone(),!0;{let B=N[D];if(typeof L=="number"||typeof L=="boolean"){if(B!==L)return N[D]=L,!0}else if(B.equals(L)===!1)return B.copy(L),!0}return!1}function _(T){let S=T.uniforms,b=0,N=16;for(let D=0,B=S.length;D<B;D++){let E=Array.isArray(S[D])?S[D]:[S[D]];for(let M=0,I=E.length;M<I;M++){let q=E[M],z=Array.isArray(q.value)?q.value:[q.value];for(let W=0,Y=z.length;W<Y;W++){let $=z[W],j=v($),Q=b%N,he=Q%j.boundary,ce=Q+he;b+=he,ce!==0&&N-ce<j.storage&&(b+=N-ce),q.__data=new Float32Array(j.storage/Float32Array.BYTES_PER_ELEMENT),q.__offset=b,b+=j.storage}}}let L=b%N;return L>0&&(b+=N-L),T.__size=b,T.__cache={},this}function v(T){let S={boundary:0,storage:0};return typeof T=="number"||typeof T=="boolean"?(S.boundary=4,S.storage=4):T.isVector2?(S.boundary=8,S.storage=8):T.isVector3||T.isColor?(S.boundary=16,S.storage=12):T.isVector4?(S.boundary=16,S.storage=16):T.isMatrix3?(S.boundary=48,S.storage=48):T.isMatrix4?(S.boundary=64,S.storage=64):T.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",T),S}function m(T){let S=T.target;S.removeEventListener("dispose",m);let b=o.indexOf(S.__bindingPointIndex);o.splice(b,1),n.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function p(){for(let T in s)n.deleteBuffer(s[T]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}var Th=class{constructor(e={}){let{canvas:t=N0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reverseDepthBuffer:f=!1}=e;this.isWebGLRenderer=!0;let d;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");d=i.getContextAttributes().alpha}else d=o;let _=new Uint32Array(4),v=new Int32Array(4),m=null,p=null,T=[],S=[];this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ls,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let b=this,N=!1;this._outputColorSpace=ni;let L=0,D=0,B=null,E=-1,M=null,I=new Yt,q=new Yt,z=null,W=new At(0),Y=0,$=t.width,j=t.height,Q=1,he=null,ce=null,_e=new Yt(0,0,$,j),Se=new Yt(0,0,$,j),me=!1,ee=new Ua,ue=!1,ve=!1,ae=new on,Ne=new on,tt=new K,Ce=new Yt,_t={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},xt=!1;function st(){return B===null?Q:1}let F=i;function Kt(w,V){return t.getContext(w,V)}try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"178"}`),t.addEventListener("webglcontextlost",Fe,!1),t.addEventListener("webglcontextrestored",fe,!1),t.addEventListener("webglcontextcreationerror",re,!1),F===null){let V="webgl2";if(F=Kt(V,w),F===null)throw Kt(V)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(w){throw console.error("THREE.WebGLRenderer: "+w.message),w}let ut,vt,ze,at,De,et,It,P,x,U,J,ne,te,Oe,ge,Ue,Re,se,ye,Ge,qe,be,Ye,k;function Me(){ut=new rS(F),ut.init(),be=new N1(F,ut),vt=new jw(F,ut,e,be),ze=new U1(F,ut),vt.reverseDepthBuffer&&f&&ze.buffers.depth.setReversed(!0),at=new lS(F),De=new b1,et=new F1(F,ut,ze,De,vt,be,at),It=new eS(b),P=new sS(b),x=new pb(F),Ye=new Jw(F,x),U=new oS(F,x,at,Ye),J=new hS(F,U,x,at),ye=new cS(F,vt,et),Ue=new Qw(De),ne=new y1(b,It,P,ut,vt,Ye,Ue),te=new z1(b,De),Oe=new w1,ge=new R1(ut),se=new Zw(b,It,P,ze,J,d,l),Re=new L1(b,J,vt),k=new V1(F,at,vt,ze),Ge=new Kw(F,ut,at),qe=new aS(F,ut,at),at.programs=ne.programs,b.capabilities=vt,b.extensions=ut,b.properties=De,b.renderLists=Oe,b.shadowMap=Re,b.state=ze,b.info=at}Me();let oe=new pd(b,F);this.xr=oe,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let w=ut.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=ut.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Q},this.setPixelRatio=function(w){w!==void 0&&(Q=w,this.setSize($,j,!1))},this.getSize=function(w){return w.set($,j)},this.setSize=function(w,V,X=!0){if(oe.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}$=w,j=V,t.width=Math.floor(w*Q),t.height=Math.floor(V*Q),X===!0&&(t.style.width=w+"px",t.style.height=V+"px"),this.setViewport(0,0,w,V)},this.getDrawingBufferSize=function(w){return w.set($*Q,j*Q).floor()},this.setDrawingBufferSize=function(w,V,X){$=w,j=V,Q=X,t.width=Math.floor(w*X),t.height=Math.floor(V*X),this.setViewport(0,0,w,V)},this.getCurrentViewport=function(w){return w.copy(I)},this.getViewport=function(w){return w.copy(_e)},this.setViewport=function(w,V,X,Z){w.isVector4?_e.set(w.x,w.y,w.z,w.w):_e.set(w,V,X,Z),ze.viewport(I.copy(_e).multiplyScalar(Q).round())},this.getScissor=function(w){return w.copy(Se)},this.setScissor=function(w,V,X,Z){w.isVector4?Se.set(w.x,w.y,w.z,w.w):Se.set(w,V,X,Z),ze.scissor(q.copy(Se).multiplyScalar(Q).round())},this.getScissorTest=function(){return me},this.setScissorTest=function(w){ze.setScissorTest(me=w)},this.setOpaqueSort=function(w){he=w},this.setTransparentSort=function(w){ce=w},this.getClearColor=function(w){return w.copy(se.getClearColor())},this.setClearColor=function(){se.setClearColor(...arguments)},this.getClearAlpha=function(){return se.getClearAlpha()},this.setClearAlpha=function(){se.setClearAlpha(...arguments)},this.clear=function(w=!0,V=!0,X=!0){let Z=0;if(w){let H=!1;if(B!==null){let de=B.texture.format;H=de===Zc||de===Yc||de===$c}if(H){let de=B.texture.type,we=de===ri||de===ks||de===Mo||de===So||de===Xc||de===qc,Le=se.getClearColor(),Pe=se.getClearAlpha(),Ze=Le.r,Je=Le.g,We=Le.b;we?(_[0]=Ze,_[1]=Je,_[2]=We,_[3]=Pe,F.clearBufferuiv(F.COLOR,0,_)):(v[0]=Ze,v[1]=Je,v[2]=We,v[3]=Pe,F.clearBufferiv(F.COLOR,0,v))}else Z|=F.COLOR_BUFFER_BIT}V&&(Z|=F.DEPTH_BUFFER_BIT),X&&(Z|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){t.removeEventListener("webglcontextlost",Fe,!1),t.removeEventListener("webglcontextrestored",fe,!1),t.removeEventListener("webglcontextcreationerror",re,!1),se.dispose(),Oe.dispose(),ge.dispose(),De.dispose(),It.dispose(),P.dispose(),J.dispose(),Ye.dispose(),k.dispose(),ne.dispose(),oe.dispose(),oe.removeEventListener("sessionstart",Xn),oe.removeEventListener("sessionend",Wi),On.stop()};function Fe(w){w.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),N=!0}function fe(){console.log("THREE.WebGLRenderer: Context Restored."),N=!1;let w=at.autoReset,V=Re.enabled,X=Re.autoUpdate,Z=Re.needsUpdate,H=Re.type;Me(),at.autoReset=w,Re.enabled=V,Re.autoUpdate=X,Re.needsUpdate=Z,Re.type=H}function re(w){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function Be(w){let V=w.target;V.removeEventListener("dispose",Be),nt(V)}function nt(w){Ut(w),De.remove(w)}function Ut(w){let V=De.get(w).programs;V!==void 0&&(V.forEach(function(X){ne.releaseProgram(X)}),w.isShaderMaterial&&ne.releaseShaderCache(w))}this.renderBufferDirect=function(w,V,X,Z,H,de){V===null&&(V=_t);let we=H.isMesh&&H.matrixWorld.determinant()<0,Le=$h(w,V,X,Z,H);ze.setMaterial(Z,we);let Pe=X.index,Ze=1;if(Z.wireframe===!0){if(Pe=U.getWireframeAttribute(X),Pe===void 0)return;Ze=2}let Je=X.drawRange,We=X.attributes.position,lt=Je.start*Ze,yt=(Je.start+Je.count)*Ze;de!==null&&(lt=Math.max(lt,de.start*Ze),yt=Math.min(yt,(de.start+de.count)*Ze)),Pe!==null?(lt=Math.max(lt,0),yt=Math.min(yt,Pe.count)):We!=null&&(lt=Math.max(lt,0),yt=Math.min(yt,We.count));let zt=yt-lt;if(zt<0||zt===1/0)return;Ye.setup(H,Z,Le,X,Pe);let ct,Ct=Ge;if(Pe!==null&&(ct=x.get(Pe),Ct=qe,Ct.setIndex(ct)),H.isMesh)Z.wireframe===!0?(ze.setLineWidth(Z.wireframeLinewidth*st()),Ct.setMode(F.LINES)):Ct.setMode(F.TRIANGLES);else if(H.isLine){let $e=Z.linewidth;$e===void 0&&($e=1),ze.setLineWidth($e*st()),H.isLineSegments?Ct.setMode(F.LINES):H.isLineLoop?Ct.setMode(F.LINE_LOOP):Ct.setMode(F.LINE_STRIP)}else H.isPoints?Ct.setMode(F.POINTS):H.isSprite&&Ct.setMode(F.TRIANGLES);if(H.isBatchedMesh)if(H._multiDrawInstances!==null)mr("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),Ct.renderMultiDrawInstances(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount,H._multiDrawInstances);else if(ut.get("WEBGL_multi_draw"))Ct.renderMultiDraw(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount);else{let $e=H._multiDrawStarts,Ft=H._multiDrawCounts,pt=H._multiDrawCount,Cn=Pe?x.get(Pe).bytesPerElement:1,ds=De.get(Z).currentProgram.getUniforms();for(let Rn=0;Rn<pt;Rn++)ds.setValue(F,"_gl_DrawID",Rn),Ct.render($e[Rn]/Cn,Ft[Rn])}else if(H.isInstancedMesh)Ct.renderInstances(lt,zt,H.count);else if(X.isInstancedBufferGeometry){let $e=X._maxInstanceCount!==void 0?X._maxInstanceCount:1/0,Ft=Math.min(X.instanceCount,$e);Ct.renderInstances(lt,zt,Ft)}else Ct.render(lt,zt)};function St(w,V,X){w.transparent===!0&&w.side===Oi&&w.forceSinglePass===!1?(w.side=Nn,w.needsUpdate=!0,Lr(w,V,X),w.side=ss,w.needsUpdate=!0,Lr(w,V,X),w.side=Oi):Lr(w,V,X)}this.compile=function(w,V,X=null){X===null&&(X=w),p=ge.get(X),p.init(V),S.push(p),X.traverseVisible(function(H){H.isLight&&H.layers.test(V.layers)&&(p.pushLight(H),H.castShadow&&p.pushShadow(H))}),w!==X&&w.traverseVisible(function(H){H.isLight&&H.layers.test(V.layers)&&(p.pushLight(H),H.castShadow&&p.pushShadow(H))}),p.setupLights();let Z=new Set;return w.traverse(function(H){if(!(H.isMesh||H.isPoints||H.isLine||H.isSprite))return;let de=H.material;if(de)if(Array.isArray(de))for(let we=0;we<de.length;we++){let Le=de[we];St(Le,X,H),Z.add(Le)}else St(de,X,H),Z.add(de)}),p=S.pop(),Z},this.compileAsync=function(w,V,X=null){let Z=this.compile(w,V,X);return new Promise(H=>{function de(){if(Z.forEach(function(we){De.get(we).currentProgram.isReady()&&Z.delete(we)}),Z.size===0){H(w);return}setTimeout(de,10)}ut.get("KHR_parallel_shader_compile")!==null?de():setTimeout(de,10)})};let an=null;function Bt(w){an&&an(w)}function Xn(){On.stop()}function Wi(){On.start()}let On=new f_;On.setAnimationLoop(Bt),typeof self<"u"&&On.setContext(self),this.setAnimationLoop=function(w){an=w,oe.setAnimationLoop(w),w===null?On.stop():On.start()},oe.addEventListener("sessionstart",Xn),oe.addEventListener("sessionend",Wi),this.render=function(w,V){if(V!==void 0&&V.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),oe.enabled===!0&&oe.isPresenting===!0&&(oe.cameraAutoUpdate===!0&&oe.updateCamera(V),V=oe.getCamera()),w.isScene===!0&&w.onBeforeRender(b,w,V,B),p=ge.get(w,S.length),p.init(V),S.push(p),Ne.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),ee.setFromProjectionMatrix(Ne),ve=this.localClippingEnabled,ue=Ue.init(this.clippingPlanes,ve),m=Oe.get(w,T.length),m.init(),T.push(m),oe.enabled===!0&&oe.isPresenting===!0){let de=b.xr.getDepthSensingMesh();de!==null&&Sn(de,V,-1/0,b.sortObjects)}Sn(w,V,0,b.sortObjects),m.finish(),b.sortObjects===!0&&m.sort(he,ce),xt=oe.enabled===!1||oe.isPresenting===!1||oe.hasDepthSensing()===!1,xt&&se.addToRenderList(m,w),this.info.render.frame++,ue===!0&&Ue.beginShadows();let X=p.state.shadowsArray;Re.render(X,w,V),ue===!0&&Ue.endShadows(),this.info.autoReset===!0&&this.info.reset();let Z=m.opaque,H=m.transmissive;if(p.setupLights(),V.isArrayCamera){let de=V.cameras;if(H.length>0)for(let we=0,Le=de.length;we<Le;we++){let Pe=de[we];qi(Z,H,w,Pe)}xt&&se.render(w);for(let we=0,Le=de.length;we<Le;we++){let Pe=de[we];Xi(m,w,Pe,Pe.viewport)}}else H.length>0&&qi(Z,H,w,V),xt&&se.render(w),Xi(m,w,V);B!==null&&D===0&&(et.updateMultisampleRenderTarget(B),et.updateRenderTargetMipmap(B)),w.isScene===!0&&w.onAfterRender(b,w,V),Ye.resetDefaultState(),E=-1,M=null,S.pop(),S.length>0?(p=S[S.length-1],ue===!0&&Ue.setGlobalState(b.clippingPlanes,p.state.camera)):p=null,T.pop(),T.length>0?m=T[T.length-1]:m=null};function Sn(w,V,X,Z){if(w.visible===!1)return;if(w.layers.test(V.layers)){if(w.isGroup)X=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(V);else if(w.isLight)p.pushLight(w),w.castShadow&&p.pushShadow(w);else if(w.isSprite){if(!w.frustumCulled||ee.intersectsSprite(w)){Z&&Ce.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Ne);let we=J.update(w),Le=w.material;Le.visible&&m.push(w,we,Le,X,Ce.z,null)}}else if((w.isMesh||w.isLine||w.isPoints)&&(!w.frustumCulled||ee.intersectsObject(w))){let we=J.update(w),Le=w.material;if(Z&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),Ce.copy(w.boundingSphere.center)):(we.boundingSphere===null&&we.computeBoundingSphere(),Ce.copy(we.boundingSphere.center)),Ce.applyMatrix4(w.matrixWorld).applyMatrix4(Ne)),Array.isArray(Le)){let Pe=we.groups;for(let Ze=0,Je=Pe.length;Ze<Je;Ze++){let We=Pe[Ze],lt=Le[We.materialIndex];lt&&lt.visible&&m.push(w,we,lt,X,Ce.z,We)}}else Le.visible&&m.push(w,we,Le,X,Ce.z,null)}}let de=w.children;for(let we=0,Le=de.length;we<Le;we++)Sn(de[we],V,X,Z)}function Xi(w,V,X,Z){let H=w.opaque,de=w.transmissive,we=w.transparent;p.setupLightsView(X),ue===!0&&Ue.setGlobalState(b.clippingPlanes,X),Z&&ze.viewport(I.copy(Z)),H.length>0&&Ws(H,V,X),de.length>0&&Ws(de,V,X),we.length>0&&Ws(we,V,X),ze.buffers.depth.setTest(!0),ze.buffers.depth.setMask(!0),ze.buffers.color.setMask(!0),ze.setPolygonOffset(!1)}function qi(w,V,X,Z){if((X.isScene===!0?X.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[Z.id]===void 0&&(p.state.transmissionRenderTarget[Z.id]=new Fi(1,1,{generateMipmaps:!0,type:ut.has("EXT_color_buffer_half_float")||ut.has("EXT_color_buffer_float")?wo:ri,minFilter:Ns,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:mt.workingColorSpace}));let de=p.state.transmissionRenderTarget[Z.id],we=Z.viewport||I;de.setSize(we.z*b.transmissionResolutionScale,we.w*b.transmissionResolutionScale);let Le=b.getRenderTarget(),Pe=b.getActiveCubeFace(),Ze=b.getActiveMipmapLevel();b.setRenderTarget(de),b.getClearColor(W),Y=b.getClearAlpha(),Y<1&&b.setClearColor(16777215,.5),b.clear(),xt&&se.render(X);let Je=b.toneMapping;b.toneMapping=ls;let We=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),p.setupLightsView(Z),ue===!0&&Ue.setGlobalState(b.clippingPlanes,Z),Ws(w,X,Z),et.updateMultisampleRenderTarget(de),et.updateRenderTargetMipmap(de),ut.has("WEBGL_multisampled_render_to_texture")===!1){let lt=!1;for(let yt=0,zt=V.length;yt<zt;yt++){let ct=V[yt],Ct=ct.object,$e=ct.geometry,Ft=ct.material,pt=ct.group;if(Ft.side===Oi&&Ct.layers.test(Z.layers)){let Cn=Ft.side;Ft.side=Nn,Ft.needsUpdate=!0,Yo(Ct,X,Z,$e,Ft,pt),Ft.side=Cn,Ft.needsUpdate=!0,lt=!0}}lt===!0&&(et.updateMultisampleRenderTarget(de),et.updateRenderTargetMipmap(de))}b.setRenderTarget(Le,Pe,Ze),b.setClearColor(W,Y),We!==void 0&&(Z.viewport=We),b.toneMapping=Je}function Ws(w,V,X){let Z=V.isScene===!0?V.overrideMaterial:null;for(let H=0,de=w.length;H<de;H++){let we=w[H],Le=we.object,Pe=we.geometry,Ze=we.group,Je=we.material;Je.allowOverride===!0&&Z!==null&&(Je=Z),Le.layers.test(X.layers)&&Yo(Le,V,X,Pe,Je,Ze)}}function Yo(w,V,X,Z,H,de){w.onBeforeRender(b,V,X,Z,H,de),w.modelViewMatrix.multiplyMatrices(X.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),H.onBeforeRender(b,V,X,Z,w,de),H.transparent===!0&&H.side===Oi&&H.forceSinglePass===!1?(H.side=Nn,H.needsUpdate=!0,b.renderBufferDirect(X,V,Z,H,w,de),H.side=ss,H.needsUpdate=!0,b.renderBufferDirect(X,V,Z,H,w,de),H.side=Oi):b.renderBufferDirect(X,V,Z,H,w,de),w.onAfterRender(b,V,X,Z,H,de)}function Lr(w,V,X){V.isScene!==!0&&(V=_t);let Z=De.get(w),H=p.state.lights,de=p.state.shadowsArray,we=H.state.version,Le=ne.getParameters(w,H.state,de,V,X),Pe=ne.getProgramCacheKey(Le),Ze=Z.programs;Z.environment=w.isMeshStandardMaterial?V.environment:null,Z.fog=V.fog,Z.envMap=(w.isMeshStandardMaterial?P:It).get(w.envMap||Z.environment),Z.envMapRotation=Z.environment!==null&&w.envMap===null?V.environmentRotation:w.envMapRotation,Ze===void 0&&(w.addEventListener("dispose",Be),Ze=new Map,Z.programs=Ze);let Je=Ze.get(Pe);if(Je!==void 0){if(Z.currentProgram===Je&&Z.lightsStateVersion===we)return Si(w,Le),Je}else Le.uniforms=ne.getUniforms(w),w.onBeforeCompile(Le,b),Je=ne.acquireProgram(Le,Pe),Ze.set(Pe,Je),Z.uniforms=Le.uniforms;let We=Z.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(We.clippingPlanes=Ue.uniform),Si(w,Le),Z.needsLights=ml(w),Z.lightsStateVersion=we,Z.needsLights&&(We.ambientLightColor.value=H.state.ambient,We.lightProbe.value=H.state.probe,We.directionalLights.value=H.state.directional,We.directionalLightShadows.value=H.state.directionalShadow,We.spotLights.value=H.state.spot,We.spotLightShadows.value=H.state.spotShadow,We.rectAreaLights.value=H.state.rectArea,We.ltc_1.value=H.state.rectAreaLTC1,We.ltc_2.value=H.state.rectAreaLTC2,We.pointLights.value=H.state.point,We.pointLightShadows.value=H.state.pointShadow,We.hemisphereLights.value=H.state.hemi,We.directionalShadowMap.value=H.state.directionalShadowMap,We.directionalShadowMatrix.value=H.state.directionalShadowMatrix,We.spotShadowMap.value=H.state.spotShadowMap,We.spotLightMatrix.value=H.state.spotLightMatrix,We.spotLightMap.value=H.state.spotLightMap,We.pointShadowMap.value=H.state.pointShadowMap,We.pointShadowMatrix.value=H.state.pointShadowMatrix),Z.currentProgram=Je,Z.uniformsList=null,Je}function pl(w){if(w.uniformsList===null){let V=w.currentProgram.getUniforms();w.uniformsList=Ro.seqWithValue(V.seq,w.uniforms)}return w.uniformsList}function Si(w,V){let X=De.get(w);X.outputColorSpace=V.outputColorSpace,X.batching=V.batching,X.batchingColor=V.batchingColor,X.instancing=V.instancing,X.instancingColor=V.instancingColor,X.instancingMorph=V.instancingMorph,X.skinning=V.skinning,X.morphTargets=V.morphTargets,X.morphNormals=V.morphNormals,X.morphColors=V.morphColors,X.morphTargetsCount=V.morphTargetsCount,X.numClippingPlanes=V.numClippingPlanes,X.numIntersection=V.numClipIntersection,X.vertexAlphas=V.vertexAlphas,X.vertexTangents=V.vertexTangents,X.toneMapping=V.toneMapping}function $h(w,V,X,Z,H){V.isScene!==!0&&(V=_t),et.resetTextureUnits();let de=V.fog,we=Z.isMeshStandardMaterial?V.environment:null,Le=B===null?b.outputColorSpace:B.isXRRenderTarget===!0?B.texture.colorSpace:pr,Pe=(Z.isMeshStandardMaterial?P:It).get(Z.envMap||we),Ze=Z.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,Je=!!X.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),We=!!X.morphAttributes.position,lt=!!X.morphAttributes.normal,yt=!!X.morphAttributes.color,zt=ls;Z.toneMapped&&(B===null||B.isXRRenderTarget===!0)&&(zt=b.toneMapping);let ct=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,Ct=ct!==void 0?ct.length:0,$e=De.get(Z),Ft=p.state.lights;if(ue===!0&&(ve===!0||w!==M)){let cn=w===M&&Z.id===E;Ue.setState(Z,w,cn)}let pt=!1;Z.version===$e.__version?($e.needsLights&&$e.lightsStateVersion!==Ft.state.version||$e.outputColorSpace!==Le||H.isBatchedMesh&&$e.batching===!1||!H.isBatchedMesh&&$e.batching===!0||H.isBatchedMesh&&$e.batchingColor===!0&&H.colorTexture===null||H.isBatchedMesh&&$e.batchingColor===!1&&H.colorTexture!==null||H.isInstancedMesh&&$e.instancing===!1||!H.isInstancedMesh&&$e.instancing===!0||H.isSkinnedMesh&&$e.skinning===!1||!H.isSkinnedMesh&&$e.skinning===!0||H.isInstancedMesh&&$e.instancingColor===!0&&H.instanceColor===null||H.isInstancedMesh&&$e.instancingColor===!1&&H.instanceColor!==null||H.isInstancedMesh&&$e.instancingMorph===!0&&H.morphTexture===null||H.isInstancedMesh&&$e.instancingMorph===!1&&H.morphTexture!==null||$e.envMap!==Pe||Z.fog===!0&&$e.fog!==de||$e.numClippingPlanes!==void 0&&($e.numClippingPlanes!==Ue.numPlanes||$e.numIntersection!==Ue.numIntersection)||$e.vertexAlphas!==Ze||$e.vertexTangents!==Je||$e.morphTargets!==We||$e.morphNormals!==lt||$e.morphColors!==yt||$e.toneMapping!==zt||$e.morphTargetsCount!==Ct)&&(pt=!0):(pt=!0,$e.__version=Z.version);let Cn=$e.currentProgram;pt===!0&&(Cn=Lr(Z,V,H));let ds=!1,Rn=!1,ps=!1,Nt=Cn.getUniforms(),Bn=$e.uniforms;if(ze.useProgram(Cn.program)&&(ds=!0,Rn=!0,ps=!0),Z.id!==E&&(E=Z.id,Rn=!0),ds||M!==w){ze.buffers.depth.getReversed()?(ae.copy(w.projectionMatrix),O0(ae),B0(ae),Nt.setValue(F,"projectionMatrix",ae)):Nt.setValue(F,"projectionMatrix",w.projectionMatrix),Nt.setValue(F,"viewMatrix",w.matrixWorldInverse);let hn=Nt.map.cameraPosition;hn!==void 0&&hn.setValue(F,tt.setFromMatrixPosition(w.matrixWorld)),vt.logarithmicDepthBuffer&&Nt.setValue(F,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&Nt.setValue(F,"isOrthographic",w.isOrthographicCamera===!0),M!==w&&(M=w,Rn=!0,ps=!0)}if(H.isSkinnedMesh){Nt.setOptional(F,H,"bindMatrix"),Nt.setOptional(F,H,"bindMatrixInverse");let cn=H.skeleton;cn&&(cn.boneTexture===null&&cn.computeBoneTexture(),Nt.setValue(F,"boneTexture",cn.boneTexture,et))}H.isBatchedMesh&&(Nt.setOptional(F,H,"batchingTexture"),Nt.setValue(F,"batchingTexture",H._matricesTexture,et),Nt.setOptional(F,H,"batchingIdTexture"),Nt.setValue(F,"batchingIdTexture",H._indirectTexture,et),Nt.setOptional(F,H,"batchingColorTexture"),H._colorsTexture!==null&&Nt.setValue(F,"batchingColorTexture",H._colorsTexture,et));let In=X.morphAttributes;if((In.position!==void 0||In.normal!==void 0||In.color!==void 0)&&ye.update(H,X,Cn),(Rn||$e.receiveShadow!==H.receiveShadow)&&($e.receiveShadow=H.receiveShadow,Nt.setValue(F,"receiveShadow",H.receiveShadow)),Z.isMeshGouraudMaterial&&Z.envMap!==null&&(Bn.envMap.value=Pe,Bn.flipEnvMap.value=Pe.isCubeTexture&&Pe.isRenderTargetTexture===!1?-1:1),Z.isMeshStandardMaterial&&Z.envMap===null&&V.environment!==null&&(Bn.envMapIntensity.value=V.environmentIntensity),Rn&&(Nt.setValue(F,"toneMappingExposure",b.toneMappingExposure),$e.needsLights&&Xs(Bn,ps),de&&Z.fog===!0&&te.refreshFogUniforms(Bn,de),te.refreshMaterialUniforms(Bn,Z,Q,j,p.state.transmissionRenderTarget[w.id]),Ro.upload(F,pl($e),Bn,et)),Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Ro.upload(F,pl($e),Bn,et),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&Nt.setValue(F,"center",H.center),Nt.setValue(F,"modelViewMatrix",H.modelViewMatrix),Nt.setValue(F,"normalMatrix",H.normalMatrix),Nt.setValue(F,"modelMatrix",H.matrixWorld),Z.isShaderMaterial||Z.isRawShaderMaterial){let cn=Z.uniformsGroups;for(let hn=0,ms=cn.length;hn<ms;hn++){let $i=cn[hn];k.update($i,Cn),k.bind($i,Cn)}}return Cn}function Xs(w,V){w.ambientLightColor.needsUpdate=V,w.lightProbe.needsUpdate=V,w.directionalLights.needsUpdate=V,w.directionalLightShadows.needsUpdate=V,w.pointLights.needsUpdate=V,w.pointLightShadows.needsUpdate=V,w.spotLights.needsUpdate=V,w.spotLightShadows.needsUpdate=V,w.rectAreaLights.needsUpdate=V,w.hemisphereLights.needsUpdate=V}function ml(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return L},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return B},this.setRenderTargetTextures=function(w,V,X){let Z=De.get(w);Z.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),De.get(w.texture).__webglTexture=V,De.get(w.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:X,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,V){let X=De.get(w);X.__webglFramebuffer=V,X.__useDefaultFramebuffer=V===void 0};let Ei=F.createFramebuffer();this.setRenderTarget=function(w,V=0,X=0){B=w,L=V,D=X;let Z=!0,H=null,de=!1,we=!1;if(w){let Pe=De.get(w);if(Pe.__useDefaultFramebuffer!==void 0)ze.bindFramebuffer(F.FRAMEBUFFER,null),Z=!1;else if(Pe.__webglFramebuffer===void 0)et.setupRenderTarget(w);else if(Pe.__hasExternalTextures)et.rebindTextures(w,De.get(w.texture).__webglTexture,De.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let We=w.depthTexture;if(Pe.__boundDepthTexture!==We){if(We!==null&&De.has(We)&&(w.width!==We.image.width||w.height!==We.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");et.setupDepthRenderbuffer(w)}}let Ze=w.texture;(Ze.isData3DTexture||Ze.isDataArrayTexture||Ze.isCompressedArrayTexture)&&(we=!0);let Je=De.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Je[V])?H=Je[V][X]:H=Je[V],de=!0):w.samples>0&&et.useMultisampledRTT(w)===!1?H=De.get(w).__webglMultisampledFramebuffer:Array.isArray(Je)?H=Je[X]:H=Je,I.copy(w.viewport),q.copy(w.scissor),z=w.scissorTest}else I.copy(_e).multiplyScalar(Q).floor(),q.copy(Se).multiplyScalar(Q).floor(),z=me;if(X!==0&&(H=Ei),ze.bindFramebuffer(F.FRAMEBUFFER,H)&&Z&&ze.drawBuffers(w,H),ze.viewport(I),ze.scissor(q),ze.setScissorTest(z),de){let Pe=De.get(w.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+V,Pe.__webglTexture,X)}else if(we){let Pe=De.get(w.texture),Ze=V;F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,Pe.__webglTexture,X,Ze)}else if(w!==null&&X!==0){let Pe=De.get(w.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Pe.__webglTexture,X)}E=-1},this.readRenderTargetPixels=function(w,V,X,Z,H,de,we,Le=0){if(!(w&&w.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Pe=De.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&we!==void 0&&(Pe=Pe[we]),Pe){ze.bindFramebuffer(F.FRAMEBUFFER,Pe);try{let Ze=w.textures[Le],Je=Ze.format,We=Ze.type;if(!vt.textureFormatReadable(Je)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!vt.textureTypeReadable(We)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=w.width-Z&&X>=0&&X<=w.height-H&&(w.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Le),F.readPixels(V,X,Z,H,be.convert(Je),be.convert(We),de))}finally{let Ze=B!==null?De.get(B).__webglFramebuffer:null;ze.bindFramebuffer(F.FRAMEBUFFER,Ze)}}},this.readRenderTargetPixelsAsync=async function(w,V,X,Z,H,de,we,Le=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Pe=De.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&we!==void 0&&(Pe=Pe[we]),Pe)if(V>=0&&V<=w.width-Z&&X>=0&&X<=w.height-H){ze.bindFramebuffer(F.FRAMEBUFFER,Pe);let Ze=w.textures[Le],Je=Ze.format,We=Ze.type;if(!vt.textureFormatReadable(Je))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!vt.textureTypeReadable(We))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let lt=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,lt),F.bufferData(F.PIXEL_PACK_BUFFER,de.byteLength,F.STREAM_READ),w.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Le),F.readPixels(V,X,Z,H,be.convert(Je),be.convert(We),0);let yt=B!==null?De.get(B).__webglFramebuffer:null;ze.bindFramebuffer(F.FRAMEBUFFER,yt);let zt=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await k0(F,zt,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,lt),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,de),F.deleteBuffer(lt),F.deleteSync(zt),de}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,V=null,X=0){let Z=Math.pow(2,-X),H=Math.floor(w.image.width*Z),de=Math.floor(w.image.height*Z),we=V!==null?V.x:0,Le=V!==null?V.y:0;et.setTexture2D(w,0),F.copyTexSubImage2D(F.TEXTURE_2D,X,0,0,we,Le,H,de),ze.unbindTexture()};let ln=F.createFramebuffer(),en=F.createFramebuffer();this.copyTextureToTexture=function(w,V,X=null,Z=null,H=0,de=null){de===null&&(H!==0?(mr("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),de=H,H=0):de=0);let we,Le,Pe,Ze,Je,We,lt,yt,zt,ct=w.isCompressedTexture?w.mipmaps[de]:w.image;if(X!==null)we=X.max.x-X.min.x,Le=X.max.y-X.min.y,Pe=X.isBox3?X.max.z-X.min.z:1,Ze=X.min.x,Je=X.min.y,We=X.isBox3?X.min.z:0;else{let In=Math.pow(2,-H);we=Math.floor(ct.width*In),Le=Math.floor(ct.height*In),w.isDataArrayTexture?Pe=ct.depth:w.isData3DTexture?Pe=Math.floor(ct.depth*In):Pe=1,Ze=0,Je=0,We=0}Z!==null?(lt=Z.x,yt=Z.y,zt=Z.z):(lt=0,yt=0,zt=0);let Ct=be.convert(V.format),$e=be.convert(V.type),Ft;V.isData3DTexture?(et.setTexture3D(V,0),Ft=F.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(et.setTexture2DArray(V,0),Ft=F.TEXTURE_2D_ARRAY):(et.setTexture2D(V,0),Ft=F.TEXTURE_2D),F.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,V.flipY),F.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),F.pixelStorei(F.UNPACK_ALIGNMENT,V.unpackAlignment);let pt=F.getParameter(F.UNPACK_ROW_LENGTH),Cn=F.getParameter(F.UNPACK_IMAGE_HEIGHT),ds=F.getParameter(F.UNPACK_SKIP_PIXELS),Rn=F.getParameter(F.UNPACK_SKIP_ROWS),ps=F.getParameter(F.UNPACK_SKIP_IMAGES);F.pixelStorei(F.UNPACK_ROW_LENGTH,ct.width),F.pixelStorei(F.UNPACK_IMAGE_HEIGHT,ct.height),F.pixelStorei(F.UNPACK_SKIP_PIXELS,Ze),F.pixelStorei(F.UNPACK_SKIP_ROWS,Je),F.pixelStorei(F.UNPACK_SKIP_IMAGES,We);let Nt=w.isDataArrayTexture||w.isData3DTexture,Bn=V.isDataArrayTexture||V.isData3DTexture;if(w.isDepthTexture){let In=De.get(w),cn=De.get(V),hn=De.get(In.__renderTarget),ms=De.get(cn.__renderTarget);ze.bindFramebuffer(F.READ_FRAMEBUFFER,hn.__webglFramebuffer),ze.bindFramebuffer(F.DRAW_FRAMEBUFFER,ms.__webglFramebuffer);for(let $i=0;$i<Pe;$i++)Nt&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,De.get(w).__webglTexture,H,We+$i),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,De.get(V).__webglTexture,de,zt+$i)),F.blitFramebuffer(Ze,Je,we,Le,lt,yt,we,Le,F.DEPTH_BUFFER_BIT,F.NEAREST);ze.bindFramebuffer(F.READ_FRAMEBUFFER,null),ze.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(H!==0||w.isRenderTargetTexture||De.has(w)){let In=De.get(w),cn=De.get(V);ze.bindFramebuffer(F.READ_FRAMEBUFFER,ln),ze.bindFramebuffer(F.DRAW_FRAMEBUFFER,en);for(let hn=0;hn<Pe;hn++)Nt?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,In.__webglTexture,H,We+hn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,In.__webglTexture,H),Bn?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,cn.__webglTexture,de,zt+hn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,cn.__webglTexture,de),H!==0?F.blitFramebuffer(Ze,Je,we,Le,lt,yt,we,Le,F.COLOR_BUFFER_BIT,F.NEAREST):Bn?F.copyTexSubImage3D(Ft,de,lt,yt,zt+hn,Ze,Je,we,Le):F.copyTexSubImage2D(Ft,de,lt,yt,Ze,Je,we,Le);ze.bindFramebuffer(F.READ_FRAMEBUFFER,null),ze.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else Bn?w.isDataTexture||w.isData3DTexture?F.texSubImage3D(Ft,de,lt,yt,zt,we,Le,Pe,Ct,$e,ct.data):V.isCompressedArrayTexture?F.compressedTexSubImage3D(Ft,de,lt,yt,zt,we,Le,Pe,Ct,ct.data):F.texSubImage3D(Ft,de,lt,yt,zt,we,Le,Pe,Ct,$e,ct):w.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,de,lt,yt,we,Le,Ct,$e,ct.data):w.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,de,lt,yt,ct.width,ct.height,Ct,ct.data):F.texSubImage2D(F.TEXTURE_2D,de,lt,yt,we,Le,Ct,$e,ct);F.pixelStorei(F.UNPACK_ROW_LENGTH,pt),F.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Cn),F.pixelStorei(F.UNPACK_SKIP_PIXELS,ds),F.pixelStorei(F.UNPACK_SKIP_ROWS,Rn),F.pixelStorei(F.UNPACK_SKIP_IMAGES,ps),de===0&&V.generateMipmaps&&F.generateMipmap(Ft),ze.unbindTexture()},this.copyTextureToTexture3D=function(w,V,X=null,Z=null,H=0){return mr('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(w,V,X,Z,H)},this.initRenderTarget=function(w){De.get(w).__webglFramebuffer===void 0&&et.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?et.setTextureCube(w,0):w.isData3DTexture?et.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?et.setTexture2DArray(w,0):et.setTexture2D(w,0),ze.unbindTexture()},this.resetState=function(){L=0,D=0,B=null,ze.reset(),Ye.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Di}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=mt._getDrawingBufferColorSpace(e),t.unpackColorSpace=mt._getUnpackColorSpace()}};var H1=7,G1=3e3,W1=5e3,Os=1024,X1=`precision highp float;
in vec2 position; in float value; in float held;
uniform vec4 view;  // middle, factors to clip space
out float v_value; out float v_held;
void main() { v_value = value; v_held = held; gl_Position = vec4((position - view.xy) * view.zw, 0.0, 1.0); }`,q1=`precision highp float;
in float v_value; in float v_held;
uniform vec2 range; uniform sampler2D colours; uniform float names; uniform vec3 ground; uniform vec3 hatch; uniform float pixel;
out vec4 colour;
void main() {
  if (v_held > 0.5) {
    float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 9.0 * pixel);
    colour = vec4(stripe < 1.2 * pixel ? hatch : ground, 1.0);
    return;
  }
  if (v_value > 1e38) {  // NO_VALUE
    colour = vec4(ground, 1.0);
    return;
  }
  float x = names > 0.5 ? (mod(floor(v_value + 0.5), names) + 0.5) / 256.0
                        : (0.5 + 255.0 * clamp((v_value - range.x) / (range.y - range.x), 0.0, 1.0)) / 256.0;
  colour = vec4(texture(colours, vec2(x, 0.5)).rgb, 1.0);
}`,$1=`precision highp float;
uniform vec4 view; uniform vec2 size; uniform float width; uniform sampler2D ends; uniform sampler2D tint;
out vec3 v_tint;
void main() {
  int line = gl_VertexID / 4, corner = gl_VertexID % 4;
  ivec2 at = ivec2(line % ${Os}, line / ${Os});
  vec4 here = texelFetch(ends, at, 0);
  vec2 position = vec2(corner == 1 || corner == 2 ? 1.0 : 0.0, corner < 2 ? -1.0 : 1.0);
  vec2 a = (here.xy - view.xy) * view.zw, b = (here.zw - view.xy) * view.zw;
  vec2 along = (b - a) * size;
  float length_ = max(length(along), 1e-6);
  vec2 across = vec2(-along.y, along.x) / length_;
  vec2 cap = along / length_ * (position.x - 0.5) * width;
  gl_Position = vec4(mix(a, b, position.x) + (across * position.y * width + cap) / size, 0.0, 1.0);
  v_tint = texelFetch(tint, at, 0).rgb;
}`,Y1=`precision highp float;
in vec3 v_tint; uniform float opacity; uniform vec4 over; out vec4 colour;
void main() { colour = vec4(mix(v_tint, over.rgb, over.a), opacity); }`,__=["original","joints","outline","crosses","water","slip","contacts","bolts","supports","monitors","chosen","contact"],Z1={original:1,joints:1.4,outline:1,crosses:1.2,water:2,slip:4,contacts:2,bolts:3,supports:1.6,monitors:2,chosen:3,contact:2.4},J1={original:.55,joints:.9,outline:.8,crosses:.95,water:1,slip:1,contacts:1,bolts:1,supports:1,monitors:1,chosen:1,contact:1},K1=new Set(["crosses","water","slip","contacts","bolts","supports","monitors","contact"]),gd=class n{constructor(e,t,i,s,r){this.geometry=new pi;this.ends={value:n.texture(new Float32Array(4*Os),oi)};this.tint={value:n.texture(new Uint8Array(4*Os),ri)};this.room=0;this.kept=null;this.dirty=!1;this.seen="";this.part=new Float32Array(0);this.part_tint=new Uint8Array(0);this.empty=!0;this.shown=!0;let o=(a,l,c)=>{let u=new yo({glslVersion:To,vertexShader:$1,fragmentShader:Y1,transparent:!0,depthTest:!1,depthWrite:!1,side:2,uniforms:{view:{value:e},size:t,width:{value:a},opacity:{value:l},over:{value:c},ends:this.ends,tint:this.tint}}),h=new Fn(this.geometry,u);return h.frustumCulled=!1,h};this.drawn=[...r?[o(i+2.4,.8,[1,1,1,1])]:[],o(i,s,[0,0,0,0])],this.set(new Float32Array(0),new Uint8Array(0))}static texture(e,t){return new vo(e,Os,e.length/(4*Os),kn,t)}keep(e,t){this.kept={ends:e,colour:t},this.dirty=!0}cull(e,t,i,s,r){if(!this.kept||!this.shown)return;let{ends:o,colour:a}=this.kept,l=o.length/4<=W1,c=e?"none":l?"all":`${t} ${i} ${s} ${r}`;if(!this.dirty&&c===this.seen)return;this.dirty=!1,this.seen=c,this.part.length<o.length&&(this.part=new Float32Array(o.length),this.part_tint=new Uint8Array(3*o.length/4));let u=0;for(let h=0;h<o.length&&!e;h+=4){let[f,d,_,v]=[o[h],o[h+1],o[h+2],o[h+3]];!l&&(f<t&&_<t||f>s&&_>s||d<i&&v<i||d>r&&v>r)||(this.part[4*u]=f,this.part[4*u+1]=d,this.part[4*u+2]=_,this.part[4*u+3]=v,u+=1)}for(let h=0;h<3*u;++h)this.part_tint[h]=a[h%3];this.set(this.part.subarray(0,4*u),this.part_tint.subarray(0,3*u))}set(e,t){let i=e.length/4;i>this.room&&this.grow(i),this.ends.value.image.data.set(e);let s=this.tint.value.image.data,r=!0;for(let o=0;o<i;++o)for(let a=0;a<3;++a)r=r&&s[4*o+a]===t[3*o+a],s[4*o+a]=t[3*o+a];i>0&&(this.ends.value.needsUpdate=!0),r||(this.tint.value.needsUpdate=!0),this.geometry.setDrawRange(0,6*i),this.empty=i===0,this.show(this.shown)}grow(e){let t=Math.ceil(1.2*e/Os);this.room=t*Os,this.ends.value.dispose(),this.tint.value.dispose(),this.ends.value=n.texture(new Float32Array(4*this.room),oi),this.tint.value=n.texture(new Uint8Array(4*this.room),ri),this.ends.value.needsUpdate=this.tint.value.needsUpdate=!0;let i=new Uint32Array(6*this.room);for(let s=0;s<this.room;++s)[0,1,2,0,2,3].forEach((r,o)=>i[6*s+o]=4*s+r);this.geometry.dispose(),this.geometry.setIndex(new dn(i,1))}show(e){this.shown=e;for(let t of this.drawn)t.visible=e&&!this.empty}};function j1(){let n=document.createElement("canvas").getContext("webgl2"),e=n?.getExtension("WEBGL_debug_renderer_info"),t=n&&e?String(n.getParameter(e.UNMASKED_RENDERER_WEBGL)):"";return n?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software|basic render/i.test(t)}var Ch=class n{constructor(e,t){this.canvas=e;this.view={x:0,y:0,scale:1};this.stage=new Da;this.camera=new bo;this.window=new Yt;this.size={value:[1,1]};this.tables={magnitude:n.texture(ku("magnitude")),signed:n.texture(ku("signed"))};this.names=null;this.mesh=null;this.edges=new Uint32Array(0);this.edge_block=new Int32Array(0);this.edge_ends=new Float32Array(0);this.block_size=1;this.position=new Float32Array(0);this.theme=null;this.width=1;this.height=1;mt.enabled=!1,this.renderer=new Th({canvas:e,antialias:t<G1||!j1(),preserveDrawingBuffer:!0}),this.renderer.sortObjects=!1,this.material=new yo({glslVersion:To,vertexShader:X1,fragmentShader:q1,depthTest:!1,depthWrite:!1,side:2,uniforms:{view:{value:this.window},range:{value:[0,1]},colours:{value:this.tables.magnitude},names:{value:0},ground:{value:[1,1,1]},hatch:{value:[0,0,0]},pixel:{value:1}}}),this.cells=new Fn(new pi,this.material),this.cells.frustumCulled=!1,this.stage.add(this.cells),this.lines=Object.fromEntries(__.map(i=>[i,new gd(this.window,this.size,Z1[i],J1[i],K1.has(i))]));for(let i of __)this.stage.add(...this.lines[i].drawn)}static texture(e){let t=new vo(e,256,1,kn);return t.minFilter=t.magFilter=ii,t.needsUpdate=!0,t}use_theme(e){this.theme=e;let t=i=>i.map(s=>s/255);this.material.uniforms.ground.value=t(e.held),this.material.uniforms.hatch.value=t(e.hatch),this.renderer.setClearColor(e.ground[0]<<16|e.ground[1]<<8|e.ground[2],1),this.lines.outline.keep(this.edge_ends,e.ink)}resize(){let e=Math.min(3,globalThis.devicePixelRatio||1);this.width=Math.max(1,this.canvas.clientWidth),this.height=Math.max(1,this.canvas.clientHeight),this.renderer.outputColorSpace="srgb-linear",this.renderer.setPixelRatio(e),this.renderer.setSize(this.width,this.height,!1),this.size.value=[this.width,this.height],this.material.uniforms.pixel.value=e}use_mesh(e,t){this.mesh=e;let i=new pi,s=e.cells.length,r=new Float32Array(s);for(let a=0;a+1<e.offsets.length;++a)t(e.block[a])&&r.fill(1,e.offsets[a],e.offsets[a+1]);i.setAttribute("position",new dn(new Float32Array(2*s),2)),i.setAttribute("value",new dn(new Float32Array(s),1)),i.setAttribute("held",new dn(r,1)),i.setIndex(new dn(gg(e),1)),this.cells.geometry.dispose(),this.cells.geometry=i,this.position=new Float32Array(e.origin.length);let o=_g(e);this.edges=o.edges,this.edge_block=o.block,this.edge_ends=new Float32Array(2*this.edges.length),this.block_size=Math.sqrt(Gl(e).reduce((a,l)=>a+l,0)/Math.max(1,new Set(e.block).size))}original_lines(){let e=this.mesh?.origin??new Float32Array(0),t=new Float32Array(2*this.edges.length);return this.edges.forEach((i,s)=>t.set([e[2*i],e[2*i+1]],2*s)),t}use_original(e,t){this.lines.original.keep(e,t)}get dense(){return this.block_size*this.view.scale<H1}use_displacement(e,t){let i=this.mesh;for(let o=0;o<this.position.length;++o)this.position[o]=i.origin[o]+t*e[o];let s=this.cells.geometry.getAttribute("position"),r=s.array;for(let o=0;o<i.cells.length;++o){let a=i.cells[o];r[2*o]=this.position[2*a],r[2*o+1]=this.position[2*a+1]}s.needsUpdate=!0;for(let o=0;o<this.edges.length;++o){let a=this.edges[o];this.edge_ends[2*o]=this.position[2*a],this.edge_ends[2*o+1]=this.position[2*a+1]}this.lines.outline.keep(this.edge_ends,this.theme?.ink??[0,0,0])}get values(){return this.cells.geometry.getAttribute("value").array}use_colours(e,t,i){if(this.cells.geometry.getAttribute("value").needsUpdate=!0,this.material.uniforms.range.value=t,this.material.uniforms.names.value=e.kind==="names"?Math.max(1,i.length):0,e.kind!=="names"){this.material.uniforms.colours.value=this.tables[e.kind];return}let s=new Uint8Array(4*256);i.slice(0,256).forEach((r,o)=>s.set([...r,255],4*o)),this.names?.dispose(),this.names=n.texture(s),this.material.uniforms.colours.value=this.names}use_lines(e,t,i){this.lines[e].set(t,i)}show(e,t){this.lines[e].show(t)}choose(e){let t=[];for(let s=0;s<this.edge_block.length;++s)this.edge_block[s]===e&&t.push(...this.edge_ends.subarray(4*s,4*s+4));let i=new Uint8Array(3*t.length/4);for(let s=0;s<i.length;++s)i[s]=[230,60,0][s%3];this.lines.chosen.set(new Float32Array(t),i)}fit(e,t,i,s){let[r,o,a]=[20,52,42],[l,c]=[Math.max(20,this.width-2*r),Math.max(20,this.height-o-a)];this.view.scale=Math.min(l/Math.max(i-e,1e-9),c/Math.max(s-t,1e-9)),this.view.x=.5*(e+i),this.view.y=.5*(t+s)+.5*(o-a)/this.view.scale}zoom(e,t,i){let[s,r]=this.place(t,i);this.view.scale*=e,this.view.x=s-(t-.5*this.width)/this.view.scale,this.view.y=r+(i-.5*this.height)/this.view.scale}place(e,t){return[this.view.x+(e-.5*this.width)/this.view.scale,this.view.y-(t-.5*this.height)/this.view.scale]}pixel(e,t){return[.5*this.width+(e-this.view.x)*this.view.scale,.5*this.height-(t-this.view.y)*this.view.scale]}render(){this.window.set(this.view.x,this.view.y,2*this.view.scale/this.width,2*this.view.scale/this.height);let[e,t]=[.5*this.width/this.view.scale,.5*this.height/this.view.scale],{x:i,y:s}=this.view;for(let r of["outline","original"])this.lines[r].cull(this.dense,i-e,s-t,i+e,s+t);this.renderer.render(this.stage,this.camera)}};function Ya(n){let e=new DataView(n.buffer,n.byteOffset,n.byteLength),t=e.getUint32(0,!0),i=new Map,s=4+24*t;for(let r=0;r<t;++r){let o=4+24*r,a="";for(let m=0;m<16&&n[o+m]!==0;++m)a+=String.fromCharCode(n[o+m]);let l=e.getUint32(o+16,!0),c=e.getUint32(o+20,!0),u=l===2?1:4;if(s+u*c>n.length)throw new Error(`array ${a} is cut short`);let h=n.subarray(s,s+u*c);if(s+=u*c,l===2){i.set(a,h.slice());continue}let f=new Uint32Array(c),[d,_,v]=[c,2*c,3*c];for(let m=0;m<c;++m)f[m]=h[m]|h[d+m]<<8|h[_+m]<<16|h[v+m]<<24;i.set(a,l===0?new Float32Array(f.buffer):new Int32Array(f.buffer))}return i}async function Q1(n){if(typeof DecompressionStream>"u")throw new Error("this browser is too old to read a run: it takes Chrome 80, Firefox 113, Safari 16.4 or later");let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(e).arrayBuffer())}function gn(n,e){let t=n.get(e);if(!t)throw new Error(`there is no array ${e}; the run is damaged`);return t}function _d(n){return{origin:gn(n,"origin"),offsets:gn(n,"offsets"),cells:gn(n,"cells"),block:gn(n,"block"),material:gn(n,"material"),method:gn(n,"method")}}function eE(n){return{displacement:gn(n,"displacement"),velocity:gn(n,"velocity"),stress:gn(n,"stress"),integrator:gn(n,"integrator"),...xd(n)}}function xd(n){return{contacts:n.has("c.state")?{position:gn(n,"c.position"),normal:gn(n,"c.normal"),force:gn(n,"c.force"),slip:gn(n,"c.slip"),blocks:gn(n,"c.blocks"),state:gn(n,"c.state")}:null,bolts:n.has("b.bolt")?{position:gn(n,"b.position"),force:gn(n,"b.force"),bolt:gn(n,"b.bolt")}:null}}var vd=3e8,$a=class{constructor(e){this.run=e;this.meshes=new Map;this.frames=new Map;this.sizes=new Map;this.kept=0;if(e.format!==1)throw new Error(`the run has format ${e.format}, which this page cannot read`)}mesh(e){let t=this.meshes.get(e);return t||this.meshes.set(e,t=this.chunk(`mesh-${e}`).then(_d)),t}frame(e){let t=this.frames.get(e);return t?this.frames.delete(e):(t=this.chunk(`frame-${e}`).then(eE),t.then(i=>this.keep(e,4*(i.displacement.length+i.velocity.length+i.stress.length)),()=>this.frames.delete(e))),this.frames.set(e,t),t}async history(){return await this.chunk("history")}keep(e,t){this.sizes.set(e,t),this.kept+=t;for(let i of this.frames.keys()){if(this.kept<=vd||i===e)break;this.kept-=this.sizes.get(i)??0,this.sizes.delete(i),this.frames.delete(i)}}async chunk(e){return Ya(await Q1(await this.packed(e)))}},Rh=class extends $a{constructor(){super(JSON.parse(x_("run")))}async packed(e){let t=atob(x_(e)),i=new Uint8Array(t.length);for(let s=0;s<t.length;++s)i[s]=t.charCodeAt(s);return i}};function x_(n){let e=document.getElementById(`scree-${n}`);if(!e||e.textContent===null)throw new Error(`the report lacks its part ${n}; it is damaged`);return e.textContent}var tE=500,nE=1500,iE=3,sE=new TextDecoder,Ih=class n{constructor(e){this.waiting=e;this.live=this;this.token=eg();this.takes_commands=!1;this.carried="";this.asked=null;this.answered=()=>{};this.session=-1;this.connected=!1;this.last_status=null;this.socket=null;this.meshes=new Map;this.frames=[];this.bytes=0;this.rows=new Map;this.models_come=0;this.detail=null;this.shown=!1;this.changed=()=>{};this.ready=()=>{}}static open(e){let t=new n(e);return new Promise(i=>{t.ready=i,t.connect()})}follow(e,t){this.changed=e,this.answered=t}can_control(){return this.takes_commands&&this.token!==""}command(e){this.asked=e,this.socket?.send(`${this.token} ${e}`)}models(){return this.models_come}state(){return this.connected?this.last_status?.status??"":""}mesh(e){let t=this.meshes.get(e);return t?Promise.resolve(t):Promise.reject(new Error(`mesh ${e} has not come`))}frame(e){let t=this.frames[e];return t?Promise.resolve(t):Promise.reject(new Error(`frame ${e} has not come`))}history(){return Promise.resolve(new Map([...this.rows].map(([e,t])=>[e,Float32Array.from(t)])))}status(){if(!this.connected)return"connection to scree view lost; trying again";let e=this.last_status;if(!e)return"";let t=e.status==="running"||e.status==="paused",i=[e.status+(e.reason?`: ${e.reason}`:"")];return t&&e.silent>=iE&&i.push(`silent for ${e.silent} s`),e.status==="running"&&e.rate>0&&i.push(`${Xt(e.rate)} s/s`),e.status==="running"&&e.time_left>=0&&i.push(`${Xt(e.time_left,2)} s left`),[...i,`${zn(Math.max(e.time,this.run.frames.list[this.run.frames.list.length-1]?.time??0))} of ${zn(e.end_time)}`].join(" \xB7 ")}connect(){let e=new URL("live",location.href);e.protocol="ws:",e.hash="";let t=this.socket=new WebSocket(e);t.binaryType="arraybuffer",t.onopen=()=>{this.connected=!0,this.changed(!1)},t.onmessage=i=>this.take(new Uint8Array(i.data)),t.onclose=()=>{this.connected=!1,this.frames.length===0?this.waiting("scree view does not answer; trying again"):this.changed(!1),setTimeout(()=>this.connect(),tE)}}take(e){let t=new DataView(e.buffer,e.byteOffset).getUint32(0,!0),i=JSON.parse(sE.decode(e.subarray(4,4+t))),s=e.subarray(4+t);if(i.kind==="run"&&this.session>=0&&i.session!==this.session){location.reload();return}i.kind==="run"?this.take_run(i):i.kind==="status"?this.take_status(i):i.kind==="answer"?this.take_answer(i):i.session===this.session&&(i.kind==="mesh"?this.take_mesh(i,s):i.kind==="model"?this.take_model(i):i.kind==="detail"?this.take_detail(i,s):i.kind==="rows"?this.take_rows(i):i.kind==="events"?this.run.events=i.list:i.kind==="frame"&&this.take_frame(i,s)),(i.kind==="frame"||i.kind==="detail")&&this.socket?.send("n")}take_run(e){this.run||(this.session=e.session,this.takes_commands=e.control??!1,this.carried=e.field,this.run={format:1,written_by:e.version,title:e.title,folder:e.run,origin:e.origin,model:{blocks:[],materials:[],methods:[],supports:[],joints:{laws:[],lines:[],cracks:[]}},stages:[],frames:{list:[],stored:0,meshes:0,ranges:{},bounds:e.bounds},history:{monitors:[],ledger:[],whole:!0},contacts:!0,events:[],asked:{case:"",set:[],libraries:[],version:e.version},found:null});let{blocks:t,materials:i}=this.run.model;for(;t.length<e.blocks;)t.push({name:`block ${t.length+1}`,material:-1,held:!1,rings:[]});for(;i.length<e.materials;)i.push({name:`material ${i.length+1}`,density:NaN,young:NaN,poisson:NaN})}take_model(e){let t=this.run.model;e.blocks.forEach((i,s)=>t.blocks[s]={...i,rings:[]}),e.materials.forEach((i,s)=>t.materials[s]=i),[t.supports,t.edges,t.water,t.joints]=[e.supports,e.edges,e.water,e.joints],this.run.bolts=e.bolts>0,this.models_come+=1,this.show(),this.changed(!1)}take_detail(e,t){let i=Ya(t);this.detail={...e,...xd(i),stress:i.get("stress")??new Float32Array(0)};let s=this.run.frames.list;for(let r=s.length-1;r>=0&&s[r].time>=e.time&&s[r].mesh===e.mesh;--r)this.add_detail(this.frames[r],s[r]);this.bytes+=4*this.detail.stress.length+41*(this.detail.contacts?.state.length??0),this.changed(!1)}add_detail(e,t){let i=this.detail;!i||i.mesh!==t.mesh||i.time>t.time||([e.contacts,e.bolts,e.stress,e.detail_time]=[i.contacts,i.bolts,i.stress,i.time])}show(e=!1){this.shown||this.frames.length===0||!(e||this.models_come>0)||(this.shown=!0,this.ready(this))}take_status(e){if(e.session<0){let t=e.run?`a run named ${e.run}`:"any run";this.waiting(e.trouble||`Nothing is heard of ${t} on ${e.url}: waiting. Does it stream? scree run CASE --live`);return}e.session===this.session&&(this.last_status=e,this.run.found={status:e.status,reason:e.reason??"",final_time:e.time,steps:e.steps,cuts:e.cuts,open_close_passes:e.passes,blocks_count:e.blocks,elements:e.elements,unknowns:e.unknowns,contacts:e.contacts},this.changed(!1))}take_answer(e){e.command===this.asked&&(this.asked=null,this.answered(e))}take_mesh(e,t){let i=_d(Ya(t)),s=this.run.model.methods;for(let r of e.methods)s.includes(r)||s.push(r);i.method=i.method.map(r=>s.indexOf(e.methods[r]??""));for(let r=0;r<i.block.length;++r)this.run.model.blocks[i.block[r]].material=i.material[r];this.meshes.has(e.mesh)||this.meshes.set(e.mesh,i)}take_frame(e,t){let i=this.run.frames.list,s=i[i.length-1];if(!this.meshes.has(e.mesh)||s&&s.time===e.time&&s.mesh===e.mesh)return;let r=Ya(t),o={displacement:r.get("displacement"),scalar:r.get("scalar"),scalar_field:e.field??this.carried,velocity:new Float32Array(0),stress:new Float32Array(0),integrator:new Uint8Array(0),contacts:null,bolts:null};this.grow_ranges(o);let a=this.run.stages;a[a.length-1]?.name!==e.stage&&a.push({name:e.stage,integrator:e.integrator,duration:0,start:e.time});let l={index:i.length,time:e.time,step:e.step,mesh:e.mesh,stage:e.stage,integrator:e.integrator};i.push(l),this.add_detail(o,l),this.frames.push(o),this.bytes+=4*(o.displacement.length+o.scalar.length),this.run.frames.stored+=1;let c=this.bytes>vd;c&&this.thin(),this.frames.length===1&&setTimeout(()=>this.show(!0),nE),this.show(),this.changed(c)}grow_ranges(e){let t=ir.find(o=>o.id===e.scalar_field&&o.kind!=="names"),i={displacement:0,ux:0,uy:0},s=e.displacement;for(let o=0;o+1<s.length;o+=2){let[a,l]=[Math.abs(s[o]),Math.abs(s[o+1])];a>i.ux&&(i.ux=a),l>i.uy&&(i.uy=l);let c=Math.hypot(a,l);c>i.displacement&&(i.displacement=c)}t&&(i[t.id]=e.scalar.reduce((o,a)=>Math.abs(a)>o?Math.abs(a):o,0));let r=this.run.frames.ranges;for(let[o,a]of Object.entries(i)){let l=Math.max(a,r[o]?.[1]??0),c=zl.find(u=>u.id===o)?.kind==="signed";l>0&&(r[o]=[c?-l:0,l])}}thin(){let e=this.run.frames.list,t=o=>e[o].stage!==e[o-1]?.stage||e[o].stage!==e[o+1]?.stage||e[o].mesh!==e[o+1]?.mesh,i=e.map((o,a)=>a).filter(o=>o%2===0||o>.75*e.length||t(o));this.frames=i.map(o=>this.frames[o]);let s=i.map(o=>e[o]);e.splice(0,e.length,...s);let r=new Set(this.frames.map(o=>o.stress));this.bytes=this.frames.reduce((o,a)=>o+4*(a.displacement.length+a.scalar.length+(r.delete(a.stress)?a.stress.length:0)),0)}take_rows(e){let t=(o,...a)=>{let l=this.rows.get(o);l?l.push(...a):this.rows.set(o,a)},i=(o,a)=>!(a<=(this.rows.get(o)?.slice(-1)[0]??-1/0)),s=e.monitors;s&&s.list.length>0&&i("m0.time",s.time)&&(this.run.history.monitors=s.list.map(o=>({name:o.name,stress:!1,at:o.at})),s.list.forEach((o,a)=>{t(`m${a}.time`,s.time),t(`m${a}.u`,...o.u),t(`m${a}.v`,...o.v)}));let r=e.ledger;if(r&&i("l.time",r.time)){this.run.history.ledger=r.columns.map(o=>({name:o.name,side:o.side,meaning:""})),t("l.time",r.time);for(let o of["energy","closure","moved","passed"])t(`l.${o}`,r[o]);r.columns.forEach((o,a)=>t(`l.${a}`,o.value))}}};async function v_(n){let e=await fetch(n).catch(()=>{throw new Error("scree view does not answer; it has ended")});if(!e.ok)throw new Error((await e.text()).trim()||`the server answers with ${e.status}`);return e}var Ph=class n extends $a{static async open(){return new n(await(await v_("run.json")).json())}async packed(e){return new Uint8Array(await(await v_(e.replace("-","/"))).arrayBuffer())}};var Pd=(n,e,t)=>{if(!e.has(n))throw TypeError("Cannot "+t)},C=(n,e,t)=>(Pd(n,e,"read from private field"),t?t.call(n):e.get(n)),Te=(n,e,t)=>{if(e.has(n))throw TypeError("Cannot add the same private member more than once");e instanceof WeakSet?e.add(n):e.set(n,t)},rt=(n,e,t,i)=>(Pd(n,e,"write to private field"),i?i.call(n,t):e.set(n,t),t),Ve=(n,e,t)=>(Pd(n,e,"access private method"),t),b_=class{constructor(n){this.value=n}},Ld=class{constructor(n){this.value=n}},M_=n=>n<256?1:n<65536?2:n<1<<24?3:n<2**32?4:n<2**40?5:6,rE=n=>{if(n<127)return 1;if(n<16383)return 2;if(n<(1<<21)-1)return 3;if(n<(1<<28)-1)return 4;if(n<2**35-1)return 5;if(n<2**42-1)return 6;throw new Error("EBML VINT size not supported "+n)},Po=(n,e,t)=>{let i=0;for(let s=e;s<t;s++){let r=Math.floor(s/8),o=n[r],a=7-(s&7),l=(o&1<<a)>>a;i<<=1,i|=l}return i},oE=(n,e,t,i)=>{for(let s=e;s<t;s++){let r=Math.floor(s/8),o=n[r],a=7-(s&7);o&=~(1<<a),o|=(i&1<<t-s-1)>>t-s-1<<a,n[r]=o}},p2=Symbol("isTarget"),Wh=class{},Dd=class extends Wh{constructor(){super(...arguments),this.buffer=null}},w_=class extends Wh{constructor(n){if(super(),this.options=n,typeof n!="object")throw new TypeError("StreamTarget requires an options object to be passed to its constructor.");if(n.onData){if(typeof n.onData!="function")throw new TypeError("options.onData, when provided, must be a function.");if(n.onData.length<2)throw new TypeError("options.onData, when provided, must be a function that takes in at least two arguments (data and position). Ignoring the position argument, which specifies the byte offset at which the data is to be written, can lead to broken outputs.")}if(n.onHeader&&typeof n.onHeader!="function")throw new TypeError("options.onHeader, when provided, must be a function.");if(n.onCluster&&typeof n.onCluster!="function")throw new TypeError("options.onCluster, when provided, must be a function.");if(n.chunked!==void 0&&typeof n.chunked!="boolean")throw new TypeError("options.chunked, when provided, must be a boolean.");if(n.chunkSize!==void 0&&(!Number.isInteger(n.chunkSize)||n.chunkSize<1024))throw new TypeError("options.chunkSize, when provided, must be an integer and not smaller than 1024.")}},aE=class extends Wh{constructor(n,e){if(super(),this.stream=n,this.options=e,!(n instanceof FileSystemWritableFileStream))throw new TypeError("FileSystemWritableFileStreamTarget requires a FileSystemWritableFileStream instance.");if(e!==void 0&&typeof e!="object")throw new TypeError("FileSystemWritableFileStreamTarget's options, when provided, must be an object.");if(e&&e.chunkSize!==void 0&&(!Number.isInteger(e.chunkSize)||e.chunkSize<=0))throw new TypeError("options.chunkSize, when provided, must be a positive integer")}},Vs,wt,yd,S_,bd,E_,Md,T_,Lh,wd,Sd,A_,C_=class{constructor(){Te(this,yd),Te(this,bd),Te(this,Md),Te(this,Lh),Te(this,Sd),this.pos=0,Te(this,Vs,new Uint8Array(8)),Te(this,wt,new DataView(C(this,Vs).buffer)),this.offsets=new WeakMap,this.dataOffsets=new WeakMap}seek(n){this.pos=n}writeEBMLVarInt(n,e=rE(n)){let t=0;switch(e){case 1:C(this,wt).setUint8(t++,128|n);break;case 2:C(this,wt).setUint8(t++,64|n>>8),C(this,wt).setUint8(t++,n);break;case 3:C(this,wt).setUint8(t++,32|n>>16),C(this,wt).setUint8(t++,n>>8),C(this,wt).setUint8(t++,n);break;case 4:C(this,wt).setUint8(t++,16|n>>24),C(this,wt).setUint8(t++,n>>16),C(this,wt).setUint8(t++,n>>8),C(this,wt).setUint8(t++,n);break;case 5:C(this,wt).setUint8(t++,8|n/2**32&7),C(this,wt).setUint8(t++,n>>24),C(this,wt).setUint8(t++,n>>16),C(this,wt).setUint8(t++,n>>8),C(this,wt).setUint8(t++,n);break;case 6:C(this,wt).setUint8(t++,4|n/2**40&3),C(this,wt).setUint8(t++,n/2**32|0),C(this,wt).setUint8(t++,n>>24),C(this,wt).setUint8(t++,n>>16),C(this,wt).setUint8(t++,n>>8),C(this,wt).setUint8(t++,n);break;default:throw new Error("Bad EBML VINT size "+e)}this.write(C(this,Vs).subarray(0,t))}writeEBML(n){if(n!==null)if(n instanceof Uint8Array)this.write(n);else if(Array.isArray(n))for(let e of n)this.writeEBML(e);else if(this.offsets.set(n,this.pos),Ve(this,Lh,wd).call(this,n.id),Array.isArray(n.data)){let e=this.pos,t=n.size===-1?1:n.size??4;n.size===-1?Ve(this,yd,S_).call(this,255):this.seek(this.pos+t);let i=this.pos;if(this.dataOffsets.set(n,i),this.writeEBML(n.data),n.size!==-1){let s=this.pos-i,r=this.pos;this.seek(e),this.writeEBMLVarInt(s,t),this.seek(r)}}else if(typeof n.data=="number"){let e=n.size??M_(n.data);this.writeEBMLVarInt(e),Ve(this,Lh,wd).call(this,n.data,e)}else typeof n.data=="string"?(this.writeEBMLVarInt(n.data.length),Ve(this,Sd,A_).call(this,n.data)):n.data instanceof Uint8Array?(this.writeEBMLVarInt(n.data.byteLength,n.size),this.write(n.data)):n.data instanceof b_?(this.writeEBMLVarInt(4),Ve(this,bd,E_).call(this,n.data.value)):n.data instanceof Ld&&(this.writeEBMLVarInt(8),Ve(this,Md,T_).call(this,n.data.value))}};Vs=new WeakMap;wt=new WeakMap;yd=new WeakSet;S_=function(n){C(this,wt).setUint8(0,n),this.write(C(this,Vs).subarray(0,1))};bd=new WeakSet;E_=function(n){C(this,wt).setFloat32(0,n,!1),this.write(C(this,Vs).subarray(0,4))};Md=new WeakSet;T_=function(n){C(this,wt).setFloat64(0,n,!1),this.write(C(this,Vs))};Lh=new WeakSet;wd=function(n,e=M_(n)){let t=0;switch(e){case 6:C(this,wt).setUint8(t++,n/2**40|0);case 5:C(this,wt).setUint8(t++,n/2**32|0);case 4:C(this,wt).setUint8(t++,n>>24);case 3:C(this,wt).setUint8(t++,n>>16);case 2:C(this,wt).setUint8(t++,n>>8);case 1:C(this,wt).setUint8(t++,n);break;default:throw new Error("Bad UINT size "+e)}this.write(C(this,Vs).subarray(0,t))};Sd=new WeakSet;A_=function(n){this.write(new Uint8Array(n.split("").map(e=>e.charCodeAt(0))))};var Dh,Ir,ol,Uh,Ed,lE=class extends C_{constructor(n){super(),Te(this,Uh),Te(this,Dh,void 0),Te(this,Ir,new ArrayBuffer(2**16)),Te(this,ol,new Uint8Array(C(this,Ir))),rt(this,Dh,n)}write(n){Ve(this,Uh,Ed).call(this,this.pos+n.byteLength),C(this,ol).set(n,this.pos),this.pos+=n.byteLength}finalize(){Ve(this,Uh,Ed).call(this,this.pos),C(this,Dh).buffer=C(this,Ir).slice(0,this.pos)}};Dh=new WeakMap;Ir=new WeakMap;ol=new WeakMap;Uh=new WeakSet;Ed=function(n){let e=C(this,Ir).byteLength;for(;e<n;)e*=2;if(e===C(this,Ir).byteLength)return;let t=new ArrayBuffer(e),i=new Uint8Array(t);i.set(C(this,ol),0),rt(this,Ir,t),rt(this,ol,i)};var Lo,zi,Vi,Er,fl=class extends C_{constructor(n){super(),this.target=n,Te(this,Lo,!1),Te(this,zi,void 0),Te(this,Vi,void 0),Te(this,Er,void 0)}write(n){if(!C(this,Lo))return;let e=this.pos;if(e<C(this,Vi)){if(e+n.byteLength<=C(this,Vi))return;n=n.subarray(C(this,Vi)-e),e=0}let t=e+n.byteLength-C(this,Vi),i=C(this,zi).byteLength;for(;i<t;)i*=2;if(i!==C(this,zi).byteLength){let s=new Uint8Array(i);s.set(C(this,zi),0),rt(this,zi,s)}C(this,zi).set(n,e-C(this,Vi)),rt(this,Er,Math.max(C(this,Er),e+n.byteLength))}startTrackingWrites(){rt(this,Lo,!0),rt(this,zi,new Uint8Array(2**10)),rt(this,Vi,this.pos),rt(this,Er,this.pos)}getTrackedWrites(){if(!C(this,Lo))throw new Error("Can't get tracked writes since nothing was tracked.");let e={data:C(this,zi).subarray(0,C(this,Er)-C(this,Vi)),start:C(this,Vi),end:C(this,Er)};return rt(this,zi,void 0),rt(this,Lo,!1),e}};Lo=new WeakMap;zi=new WeakMap;Vi=new WeakMap;Er=new WeakMap;var cE=2**24,hE=2,Tr,No,Qa,Za,fs,ai,Oh,Td,Ud,R_,Fd,I_,el,Bh,Nd=class extends fl{constructor(n,e){super(n),Te(this,Oh),Te(this,Ud),Te(this,Fd),Te(this,el),Te(this,Tr,[]),Te(this,No,0),Te(this,Qa,void 0),Te(this,Za,void 0),Te(this,fs,void 0),Te(this,ai,[]),rt(this,Qa,e),rt(this,Za,n.options?.chunked??!1),rt(this,fs,n.options?.chunkSize??cE)}write(n){super.write(n),C(this,Tr).push({data:n.slice(),start:this.pos}),this.pos+=n.byteLength}flush(){if(C(this,Tr).length===0)return;let n=[],e=[...C(this,Tr)].sort((t,i)=>t.start-i.start);n.push({start:e[0].start,size:e[0].data.byteLength});for(let t=1;t<e.length;t++){let i=n[n.length-1],s=e[t];s.start<=i.start+i.size?i.size=Math.max(i.size,s.start+s.data.byteLength-i.start):n.push({start:s.start,size:s.data.byteLength})}for(let t of n){t.data=new Uint8Array(t.size);for(let i of C(this,Tr))t.start<=i.start&&i.start<t.start+t.size&&t.data.set(i.data,i.start-t.start);if(C(this,Za))Ve(this,Oh,Td).call(this,t.data,t.start),Ve(this,el,Bh).call(this);else{if(C(this,Qa)&&t.start<C(this,No))throw new Error("Internal error: Monotonicity violation.");this.target.options.onData?.(t.data,t.start),rt(this,No,t.start+t.data.byteLength)}}C(this,Tr).length=0}finalize(){C(this,Za)&&Ve(this,el,Bh).call(this,!0)}};Tr=new WeakMap;No=new WeakMap;Qa=new WeakMap;Za=new WeakMap;fs=new WeakMap;ai=new WeakMap;Oh=new WeakSet;Td=function(n,e){let t=C(this,ai).findIndex(a=>a.start<=e&&e<a.start+C(this,fs));t===-1&&(t=Ve(this,Fd,I_).call(this,e));let i=C(this,ai)[t],s=e-i.start,r=n.subarray(0,Math.min(C(this,fs)-s,n.byteLength));i.data.set(r,s);let o={start:s,end:s+r.byteLength};if(Ve(this,Ud,R_).call(this,i,o),i.written[0].start===0&&i.written[0].end===C(this,fs)&&(i.shouldFlush=!0),C(this,ai).length>hE){for(let a=0;a<C(this,ai).length-1;a++)C(this,ai)[a].shouldFlush=!0;Ve(this,el,Bh).call(this)}r.byteLength<n.byteLength&&Ve(this,Oh,Td).call(this,n.subarray(r.byteLength),e+r.byteLength)};Ud=new WeakSet;R_=function(n,e){let t=0,i=n.written.length-1,s=-1;for(;t<=i;){let r=Math.floor(t+(i-t+1)/2);n.written[r].start<=e.start?(t=r+1,s=r):i=r-1}for(n.written.splice(s+1,0,e),(s===-1||n.written[s].end<e.start)&&s++;s<n.written.length-1&&n.written[s].end>=n.written[s+1].start;)n.written[s].end=Math.max(n.written[s].end,n.written[s+1].end),n.written.splice(s+1,1)};Fd=new WeakSet;I_=function(n){let t={start:Math.floor(n/C(this,fs))*C(this,fs),data:new Uint8Array(C(this,fs)),written:[],shouldFlush:!1};return C(this,ai).push(t),C(this,ai).sort((i,s)=>i.start-s.start),C(this,ai).indexOf(t)};el=new WeakSet;Bh=function(n=!1){for(let e=0;e<C(this,ai).length;e++){let t=C(this,ai)[e];if(!(!t.shouldFlush&&!n)){for(let i of t.written){if(C(this,Qa)&&t.start+i.start<C(this,No))throw new Error("Internal error: Monotonicity violation.");this.target.options.onData?.(t.data.subarray(i.start,i.end),t.start+i.start),rt(this,No,t.start+i.end)}C(this,ai).splice(e--,1)}}};var uE=class extends Nd{constructor(n,e){super(new w_({onData:(t,i)=>n.stream.write({type:"write",data:t,position:i}),chunked:!0,chunkSize:n.options?.chunkSize}),e)}},Go=1,al=2,zh=3,fE=1,dE=2,pE=17,mE=2**15,tl=2**13,y_="https://github.com/Vanilagy/webm-muxer",P_=6,L_=5,gE=["strict","offset","permissive"],je,He,ll,cl,us,Wo,Do,Pr,Xo,Hs,ko,Oo,Gi,dl,Bo,Bs,zs,Ar,nl,il,zo,Vo,Vh,hl,sl,Ad,D_,Cd,U_,kd,F_,Od,N_,Bd,k_,zd,O_,Vd,B_,Xh,Hd,qh,Gd,Wd,z_,Cr,Uo,Rr,Fo,Rd,V_,Id,H_,Ja,Fh,Ka,Nh,Xd,G_,Hi,hs,Ho,ul,rl,Hh,qd,W_,Gh,$d,ja,kh,X_=class{constructor(n){Te(this,Ad),Te(this,Cd),Te(this,kd),Te(this,Od),Te(this,Bd),Te(this,zd),Te(this,Vd),Te(this,Xh),Te(this,qh),Te(this,Wd),Te(this,Cr),Te(this,Rr),Te(this,Rd),Te(this,Id),Te(this,Ja),Te(this,Ka),Te(this,Xd),Te(this,Hi),Te(this,Ho),Te(this,rl),Te(this,qd),Te(this,Gh),Te(this,ja),Te(this,je,void 0),Te(this,He,void 0),Te(this,ll,void 0),Te(this,cl,void 0),Te(this,us,void 0),Te(this,Wo,void 0),Te(this,Do,void 0),Te(this,Pr,void 0),Te(this,Xo,void 0),Te(this,Hs,void 0),Te(this,ko,void 0),Te(this,Oo,void 0),Te(this,Gi,void 0),Te(this,dl,void 0),Te(this,Bo,0),Te(this,Bs,[]),Te(this,zs,[]),Te(this,Ar,[]),Te(this,nl,void 0),Te(this,il,void 0),Te(this,zo,-1),Te(this,Vo,-1),Te(this,Vh,-1),Te(this,hl,void 0),Te(this,sl,!1),Ve(this,Ad,D_).call(this,n),rt(this,je,{type:"webm",firstTimestampBehavior:"strict",...n}),this.target=n.target;let e=!!C(this,je).streaming;if(n.target instanceof Dd)rt(this,He,new lE(n.target));else if(n.target instanceof w_)rt(this,He,new Nd(n.target,e));else if(n.target instanceof aE)rt(this,He,new uE(n.target,e));else throw new Error(`Invalid target: ${n.target}`);Ve(this,Cd,U_).call(this)}addVideoChunk(n,e,t){if(!(n instanceof EncodedVideoChunk))throw new TypeError("addVideoChunk's first argument (chunk) must be of type EncodedVideoChunk.");if(e&&typeof e!="object")throw new TypeError("addVideoChunk's second argument (meta), when provided, must be an object.");if(t!==void 0&&(!Number.isFinite(t)||t<0))throw new TypeError("addVideoChunk's third argument (timestamp), when provided, must be a non-negative real number.");let i=new Uint8Array(n.byteLength);n.copyTo(i),this.addVideoChunkRaw(i,n.type,t??n.timestamp,e)}addVideoChunkRaw(n,e,t,i){if(!(n instanceof Uint8Array))throw new TypeError("addVideoChunkRaw's first argument (data) must be an instance of Uint8Array.");if(e!=="key"&&e!=="delta")throw new TypeError("addVideoChunkRaw's second argument (type) must be either 'key' or 'delta'.");if(!Number.isFinite(t)||t<0)throw new TypeError("addVideoChunkRaw's third argument (timestamp) must be a non-negative real number.");if(i&&typeof i!="object")throw new TypeError("addVideoChunkRaw's fourth argument (meta), when provided, must be an object.");if(Ve(this,ja,kh).call(this),!C(this,je).video)throw new Error("No video track declared.");C(this,nl)===void 0&&rt(this,nl,t),i&&Ve(this,Rd,V_).call(this,i);let s=Ve(this,Ka,Nh).call(this,n,e,t,Go);for(C(this,je).video.codec==="V_VP9"&&Ve(this,Id,H_).call(this,s),rt(this,zo,s.timestamp);C(this,zs).length>0&&C(this,zs)[0].timestamp<=s.timestamp;){let r=C(this,zs).shift();Ve(this,Hi,hs).call(this,r,!1)}!C(this,je).audio||s.timestamp<=C(this,Vo)?Ve(this,Hi,hs).call(this,s,!0):C(this,Bs).push(s),Ve(this,Ja,Fh).call(this),Ve(this,Cr,Uo).call(this)}addAudioChunk(n,e,t){if(!(n instanceof EncodedAudioChunk))throw new TypeError("addAudioChunk's first argument (chunk) must be of type EncodedAudioChunk.");if(e&&typeof e!="object")throw new TypeError("addAudioChunk's second argument (meta), when provided, must be an object.");if(t!==void 0&&(!Number.isFinite(t)||t<0))throw new TypeError("addAudioChunk's third argument (timestamp), when provided, must be a non-negative real number.");let i=new Uint8Array(n.byteLength);n.copyTo(i),this.addAudioChunkRaw(i,n.type,t??n.timestamp,e)}addAudioChunkRaw(n,e,t,i){if(!(n instanceof Uint8Array))throw new TypeError("addAudioChunkRaw's first argument (data) must be an instance of Uint8Array.");if(e!=="key"&&e!=="delta")throw new TypeError("addAudioChunkRaw's second argument (type) must be either 'key' or 'delta'.");if(!Number.isFinite(t)||t<0)throw new TypeError("addAudioChunkRaw's third argument (timestamp) must be a non-negative real number.");if(i&&typeof i!="object")throw new TypeError("addAudioChunkRaw's fourth argument (meta), when provided, must be an object.");if(Ve(this,ja,kh).call(this),!C(this,je).audio)throw new Error("No audio track declared.");C(this,il)===void 0&&rt(this,il,t),i?.decoderConfig&&(C(this,je).streaming?rt(this,Hs,Ve(this,Ho,ul).call(this,i.decoderConfig.description)):Ve(this,rl,Hh).call(this,C(this,Hs),i.decoderConfig.description));let s=Ve(this,Ka,Nh).call(this,n,e,t,al);for(rt(this,Vo,s.timestamp);C(this,Bs).length>0&&C(this,Bs)[0].timestamp<=s.timestamp;){let r=C(this,Bs).shift();Ve(this,Hi,hs).call(this,r,!0)}!C(this,je).video||s.timestamp<=C(this,zo)?Ve(this,Hi,hs).call(this,s,!C(this,je).video):C(this,zs).push(s),Ve(this,Ja,Fh).call(this),Ve(this,Cr,Uo).call(this)}addSubtitleChunk(n,e,t){if(typeof n!="object"||!n)throw new TypeError("addSubtitleChunk's first argument (chunk) must be an object.");if(!(n.body instanceof Uint8Array))throw new TypeError("body must be an instance of Uint8Array.");if(!Number.isFinite(n.timestamp)||n.timestamp<0)throw new TypeError("timestamp must be a non-negative real number.");if(!Number.isFinite(n.duration)||n.duration<0)throw new TypeError("duration must be a non-negative real number.");if(n.additions&&!(n.additions instanceof Uint8Array))throw new TypeError("additions, when present, must be an instance of Uint8Array.");if(typeof e!="object")throw new TypeError("addSubtitleChunk's second argument (meta) must be an object.");if(Ve(this,ja,kh).call(this),!C(this,je).subtitles)throw new Error("No subtitle track declared.");e?.decoderConfig&&(C(this,je).streaming?rt(this,ko,Ve(this,Ho,ul).call(this,e.decoderConfig.description)):Ve(this,rl,Hh).call(this,C(this,ko),e.decoderConfig.description));let i=Ve(this,Ka,Nh).call(this,n.body,"key",t??n.timestamp,zh,n.duration,n.additions);rt(this,Vh,i.timestamp),C(this,Ar).push(i),Ve(this,Ja,Fh).call(this),Ve(this,Cr,Uo).call(this)}finalize(){if(C(this,sl))throw new Error("Cannot finalize a muxer more than once.");for(;C(this,Bs).length>0;)Ve(this,Hi,hs).call(this,C(this,Bs).shift(),!0);for(;C(this,zs).length>0;)Ve(this,Hi,hs).call(this,C(this,zs).shift(),!0);for(;C(this,Ar).length>0&&C(this,Ar)[0].timestamp<=C(this,Bo);)Ve(this,Hi,hs).call(this,C(this,Ar).shift(),!1);if(C(this,Gi)&&Ve(this,Gh,$d).call(this),C(this,He).writeEBML(C(this,Oo)),!C(this,je).streaming){let n=C(this,He).pos,e=C(this,He).pos-C(this,Rr,Fo);C(this,He).seek(C(this,He).offsets.get(C(this,ll))+4),C(this,He).writeEBMLVarInt(e,P_),C(this,Do).data=new Ld(C(this,Bo)),C(this,He).seek(C(this,He).offsets.get(C(this,Do))),C(this,He).writeEBML(C(this,Do)),C(this,us).data[0].data[1].data=C(this,He).offsets.get(C(this,Oo))-C(this,Rr,Fo),C(this,us).data[1].data[1].data=C(this,He).offsets.get(C(this,cl))-C(this,Rr,Fo),C(this,us).data[2].data[1].data=C(this,He).offsets.get(C(this,Wo))-C(this,Rr,Fo),C(this,He).seek(C(this,He).offsets.get(C(this,us))),C(this,He).writeEBML(C(this,us)),C(this,He).seek(n)}Ve(this,Cr,Uo).call(this),C(this,He).finalize(),rt(this,sl,!0)}};je=new WeakMap;He=new WeakMap;ll=new WeakMap;cl=new WeakMap;us=new WeakMap;Wo=new WeakMap;Do=new WeakMap;Pr=new WeakMap;Xo=new WeakMap;Hs=new WeakMap;ko=new WeakMap;Oo=new WeakMap;Gi=new WeakMap;dl=new WeakMap;Bo=new WeakMap;Bs=new WeakMap;zs=new WeakMap;Ar=new WeakMap;nl=new WeakMap;il=new WeakMap;zo=new WeakMap;Vo=new WeakMap;Vh=new WeakMap;hl=new WeakMap;sl=new WeakMap;Ad=new WeakSet;D_=function(n){if(typeof n!="object")throw new TypeError("The muxer requires an options object to be passed to its constructor.");if(!(n.target instanceof Wh))throw new TypeError("The target must be provided and an instance of Target.");if(n.video){if(typeof n.video.codec!="string")throw new TypeError(`Invalid video codec: ${n.video.codec}. Must be a string.`);if(!Number.isInteger(n.video.width)||n.video.width<=0)throw new TypeError(`Invalid video width: ${n.video.width}. Must be a positive integer.`);if(!Number.isInteger(n.video.height)||n.video.height<=0)throw new TypeError(`Invalid video height: ${n.video.height}. Must be a positive integer.`);if(n.video.frameRate!==void 0&&(!Number.isFinite(n.video.frameRate)||n.video.frameRate<=0))throw new TypeError(`Invalid video frame rate: ${n.video.frameRate}. Must be a positive number.`);if(n.video.alpha!==void 0&&typeof n.video.alpha!="boolean")throw new TypeError(`Invalid video alpha: ${n.video.alpha}. Must be a boolean.`)}if(n.audio){if(typeof n.audio.codec!="string")throw new TypeError(`Invalid audio codec: ${n.audio.codec}. Must be a string.`);if(!Number.isInteger(n.audio.numberOfChannels)||n.audio.numberOfChannels<=0)throw new TypeError(`Invalid number of audio channels: ${n.audio.numberOfChannels}. Must be a positive integer.`);if(!Number.isInteger(n.audio.sampleRate)||n.audio.sampleRate<=0)throw new TypeError(`Invalid audio sample rate: ${n.audio.sampleRate}. Must be a positive integer.`);if(n.audio.bitDepth!==void 0&&(!Number.isInteger(n.audio.bitDepth)||n.audio.bitDepth<=0))throw new TypeError(`Invalid audio bit depth: ${n.audio.bitDepth}. Must be a positive integer.`)}if(n.subtitles&&typeof n.subtitles.codec!="string")throw new TypeError(`Invalid subtitles codec: ${n.subtitles.codec}. Must be a string.`);if(n.type!==void 0&&!["webm","matroska"].includes(n.type))throw new TypeError(`Invalid type: ${n.type}. Must be 'webm' or 'matroska'.`);if(n.firstTimestampBehavior&&!gE.includes(n.firstTimestampBehavior))throw new TypeError(`Invalid first timestamp behavior: ${n.firstTimestampBehavior}`);if(n.streaming!==void 0&&typeof n.streaming!="boolean")throw new TypeError(`Invalid streaming option: ${n.streaming}. Must be a boolean.`)};Cd=new WeakSet;U_=function(){C(this,He)instanceof fl&&C(this,He).target.options.onHeader&&C(this,He).startTrackingWrites(),Ve(this,kd,F_).call(this),C(this,je).streaming||Ve(this,zd,O_).call(this),Ve(this,Vd,B_).call(this),Ve(this,Od,N_).call(this),Ve(this,Bd,k_).call(this),C(this,je).streaming||(Ve(this,Xh,Hd).call(this),Ve(this,qh,Gd).call(this)),Ve(this,Wd,z_).call(this),Ve(this,Cr,Uo).call(this)};kd=new WeakSet;F_=function(){let n={id:440786851,data:[{id:17030,data:1},{id:17143,data:1},{id:17138,data:4},{id:17139,data:8},{id:17026,data:C(this,je).type??"webm"},{id:17031,data:2},{id:17029,data:2}]};C(this,He).writeEBML(n)};Od=new WeakSet;N_=function(){rt(this,Xo,{id:236,size:4,data:new Uint8Array(tl)}),rt(this,Hs,{id:236,size:4,data:new Uint8Array(tl)}),rt(this,ko,{id:236,size:4,data:new Uint8Array(tl)})};Bd=new WeakSet;k_=function(){rt(this,Pr,{id:21936,data:[{id:21937,data:2},{id:21946,data:2},{id:21947,data:2},{id:21945,data:0}]})};zd=new WeakSet;O_=function(){let n=new Uint8Array([28,83,187,107]),e=new Uint8Array([21,73,169,102]),t=new Uint8Array([22,84,174,107]);rt(this,us,{id:290298740,data:[{id:19899,data:[{id:21419,data:n},{id:21420,size:5,data:0}]},{id:19899,data:[{id:21419,data:e},{id:21420,size:5,data:0}]},{id:19899,data:[{id:21419,data:t},{id:21420,size:5,data:0}]}]})};Vd=new WeakSet;B_=function(){let n={id:17545,data:new Ld(0)};rt(this,Do,n);let e={id:357149030,data:[{id:2807729,data:1e6},{id:19840,data:y_},{id:22337,data:y_},C(this,je).streaming?null:n]};rt(this,cl,e)};Xh=new WeakSet;Hd=function(){let n={id:374648427,data:[]};rt(this,Wo,n),C(this,je).video&&n.data.push({id:174,data:[{id:215,data:Go},{id:29637,data:Go},{id:131,data:fE},{id:134,data:C(this,je).video.codec},C(this,Xo),C(this,je).video.frameRate?{id:2352003,data:1e9/C(this,je).video.frameRate}:null,{id:224,data:[{id:176,data:C(this,je).video.width},{id:186,data:C(this,je).video.height},C(this,je).video.alpha?{id:21440,data:1}:null,C(this,Pr)]}]}),C(this,je).audio&&(rt(this,Hs,C(this,je).streaming?C(this,Hs)||null:{id:236,size:4,data:new Uint8Array(tl)}),n.data.push({id:174,data:[{id:215,data:al},{id:29637,data:al},{id:131,data:dE},{id:134,data:C(this,je).audio.codec},C(this,Hs),{id:225,data:[{id:181,data:new b_(C(this,je).audio.sampleRate)},{id:159,data:C(this,je).audio.numberOfChannels},C(this,je).audio.bitDepth?{id:25188,data:C(this,je).audio.bitDepth}:null]}]})),C(this,je).subtitles&&n.data.push({id:174,data:[{id:215,data:zh},{id:29637,data:zh},{id:131,data:pE},{id:134,data:C(this,je).subtitles.codec},C(this,ko)]})};qh=new WeakSet;Gd=function(){let n={id:408125543,size:C(this,je).streaming?-1:P_,data:[C(this,je).streaming?null:C(this,us),C(this,cl),C(this,Wo)]};if(rt(this,ll,n),C(this,He).writeEBML(n),C(this,He)instanceof fl&&C(this,He).target.options.onHeader){let{data:e,start:t}=C(this,He).getTrackedWrites();C(this,He).target.options.onHeader(e,t)}};Wd=new WeakSet;z_=function(){rt(this,Oo,{id:475249515,data:[]})};Cr=new WeakSet;Uo=function(){C(this,He)instanceof Nd&&C(this,He).flush()};Rr=new WeakSet;Fo=function(){return C(this,He).dataOffsets.get(C(this,ll))};Rd=new WeakSet;V_=function(n){if(n.decoderConfig){if(n.decoderConfig.colorSpace){let e=n.decoderConfig.colorSpace;if(rt(this,hl,e),C(this,Pr).data=[{id:21937,data:{rgb:1,bt709:1,bt470bg:5,smpte170m:6}[e.matrix]},{id:21946,data:{bt709:1,smpte170m:6,"iec61966-2-1":13}[e.transfer]},{id:21947,data:{bt709:1,bt470bg:5,smpte170m:6}[e.primaries]},{id:21945,data:[1,2][Number(e.fullRange)]}],!C(this,je).streaming){let t=C(this,He).pos;C(this,He).seek(C(this,He).offsets.get(C(this,Pr))),C(this,He).writeEBML(C(this,Pr)),C(this,He).seek(t)}}n.decoderConfig.description&&(C(this,je).streaming?rt(this,Xo,Ve(this,Ho,ul).call(this,n.decoderConfig.description)):Ve(this,rl,Hh).call(this,C(this,Xo),n.decoderConfig.description))}};Id=new WeakSet;H_=function(n){if(n.type!=="key"||!C(this,hl))return;let e=0;if(Po(n.data,0,2)!==2)return;e+=2;let t=(Po(n.data,e+1,e+2)<<1)+Po(n.data,e+0,e+1);e+=2,t===3&&e++;let i=Po(n.data,e+0,e+1);if(e++,i)return;let s=Po(n.data,e+0,e+1);if(e++,s!==0)return;e+=2;let r=Po(n.data,e+0,e+24);if(e+=24,r!==4817730)return;t>=2&&e++;let o={rgb:7,bt709:2,bt470bg:1,smpte170m:3}[C(this,hl).matrix];oE(n.data,e+0,e+3,o)};Ja=new WeakSet;Fh=function(){let n=Math.min(C(this,je).video?C(this,zo):1/0,C(this,je).audio?C(this,Vo):1/0),e=C(this,Ar);for(;e.length>0&&e[0].timestamp<=n;)Ve(this,Hi,hs).call(this,e.shift(),!C(this,je).video&&!C(this,je).audio)};Ka=new WeakSet;Nh=function(n,e,t,i,s,r){let o=Ve(this,Xd,G_).call(this,t,i);return{data:n,additions:r,type:e,timestamp:o,duration:s,trackNumber:i}};Xd=new WeakSet;G_=function(n,e){let t=e===Go?C(this,zo):e===al?C(this,Vo):C(this,Vh);if(e!==zh){let i=e===Go?C(this,nl):C(this,il);if(C(this,je).firstTimestampBehavior==="strict"&&t===-1&&n!==0)throw new Error(`The first chunk for your media track must have a timestamp of 0 (received ${n}). Non-zero first timestamps are often caused by directly piping frames or audio data from a MediaStreamTrack into the encoder. Their timestamps are typically relative to the age of the document, which is probably what you want.

If you want to offset all timestamps of a track such that the first one is zero, set firstTimestampBehavior: 'offset' in the options.
If you want to allow non-zero first timestamps, set firstTimestampBehavior: 'permissive'.
`);C(this,je).firstTimestampBehavior==="offset"&&(n-=i)}if(n<t)throw new Error(`Timestamps must be monotonically increasing (went from ${t} to ${n}).`);if(n<0)throw new Error(`Timestamps must be non-negative (received ${n}).`);return n};Hi=new WeakSet;hs=function(n,e){C(this,je).streaming&&!C(this,Wo)&&(Ve(this,Xh,Hd).call(this),Ve(this,qh,Gd).call(this));let t=Math.floor(n.timestamp/1e3),i=t-C(this,dl),s=e&&n.type==="key"&&i>=1e3,r=i>=mE;if((!C(this,Gi)||s||r)&&(Ve(this,qd,W_).call(this,t),i=0),i<0)return;let o=new Uint8Array(4),a=new DataView(o.buffer);if(a.setUint8(0,128|n.trackNumber),a.setInt16(1,i,!1),n.duration===void 0&&!n.additions){a.setUint8(3,+(n.type==="key")<<7);let l={id:163,data:[o,n.data]};C(this,He).writeEBML(l)}else{let l=Math.floor(n.duration/1e3),c={id:160,data:[{id:161,data:[o,n.data]},n.duration!==void 0?{id:155,data:l}:null,n.additions?{id:30113,data:n.additions}:null]};C(this,He).writeEBML(c)}rt(this,Bo,Math.max(C(this,Bo),t))};Ho=new WeakSet;ul=function(n){return{id:25506,size:4,data:new Uint8Array(n)}};rl=new WeakSet;Hh=function(n,e){let t=C(this,He).pos;C(this,He).seek(C(this,He).offsets.get(n));let i=6+e.byteLength,s=tl-i;if(s<0){let r=e.byteLength+s;e instanceof ArrayBuffer?e=e.slice(0,r):e=e.buffer.slice(0,r),s=0}n=[Ve(this,Ho,ul).call(this,e),{id:236,size:4,data:new Uint8Array(s)}],C(this,He).writeEBML(n),C(this,He).seek(t)};qd=new WeakSet;W_=function(n){C(this,Gi)&&Ve(this,Gh,$d).call(this),C(this,He)instanceof fl&&C(this,He).target.options.onCluster&&C(this,He).startTrackingWrites(),rt(this,Gi,{id:524531317,size:C(this,je).streaming?-1:L_,data:[{id:231,data:n}]}),C(this,He).writeEBML(C(this,Gi)),rt(this,dl,n);let e=C(this,He).offsets.get(C(this,Gi))-C(this,Rr,Fo);C(this,Oo).data.push({id:187,data:[{id:179,data:n},C(this,je).video?{id:183,data:[{id:247,data:Go},{id:241,data:e}]}:null,C(this,je).audio?{id:183,data:[{id:247,data:al},{id:241,data:e}]}:null]})};Gh=new WeakSet;$d=function(){if(!C(this,je).streaming){let n=C(this,He).pos-C(this,He).dataOffsets.get(C(this,Gi)),e=C(this,He).pos;C(this,He).seek(C(this,He).offsets.get(C(this,Gi))+4),C(this,He).writeEBMLVarInt(n,L_),C(this,He).seek(e)}if(C(this,He)instanceof fl&&C(this,He).target.options.onCluster){let{data:n,start:e}=C(this,He).getTrackedWrites();C(this,He).target.options.onCluster(n,e,C(this,dl))}};ja=new WeakSet;kh=function(){if(C(this,sl))throw new Error("Cannot add new video or audio chunks after the file has been finalized.")};var _E=/(?:(\d{2}):)?(\d{2}):(\d{2}).(\d{3})/;var m2=new TextEncoder,xE,vE,yE,bE,ME,wE,SE,EE,TE;xE=new WeakMap;vE=new WeakMap;yE=new WeakMap;bE=new WeakMap;ME=new WeakMap;wE=new WeakSet;SE=function(n){let e=_E.exec(n);if(!e)throw new Error("Expected match.");return 3600*1e3*Number(e[1]||"0")+60*1e3*Number(e[2])+1e3*Number(e[3])+Number(e[4])};EE=new WeakSet;TE=function(n){let e=Math.floor(n/36e5),t=Math.floor(n%(3600*1e3)/(60*1e3)),i=Math.floor(n%(60*1e3)/1e3),s=n%1e3;return e.toString().padStart(2,"0")+":"+t.toString().padStart(2,"0")+":"+i.toString().padStart(2,"0")+"."+s.toString().padStart(3,"0")};var qo=25,AE=60,CE=50,RE=6,IE=.12,PE=[{name:"vp09.00.51.08",track:"V_VP9"},{name:"vp8",track:"V_VP8"}];function q_(n,e,t){let i=Math.max(t,(e-n)/AE)/qo,s=Math.ceil((e-n)/i);return[...Array.from({length:s+1},(o,a)=>Math.min(e,n+a*i)),...Array.from({length:qo},()=>e)]}async function $_(n,e,t){let i=document.createElement("canvas"),s=null,r=[0,0];for(let o=0;o<n.length&&t(o/n.length);++o){if(await e(n[o],i),!s&&(r.splice(0,2,i.width,i.height),s=await LE(i.width,i.height),!s))throw new Error("this browser cannot encode films (WebCodecs); Chrome 94, Firefox 130, Safari 16.4 or later can");if(i.width!==r[0]||i.height!==r[1])throw new Error("the window has changed its size");await s.add(i),o%5===4&&await new Promise(a=>setTimeout(a))}if(!s)throw new Error("it was ended before its first picture");return s.end()}async function LE(n,e){if(typeof VideoEncoder>"u")return null;for(let{name:t,track:i}of PE){let s={codec:t,width:n,height:e,framerate:qo,bitrate:Math.round(IE*n*e*qo),latencyMode:"quality"},{supported:r}=await VideoEncoder.isConfigSupported(s).catch(()=>({supported:!1}));if(r)return new Yd(s,i)}return null}var Yd=class{constructor(e,t){this.target=new Dd;this.failure=null;this.count=0;this.muxer=new X_({target:this.target,video:{codec:t,width:e.width,height:e.height,frameRate:qo}}),this.encoder=new VideoEncoder({output:(i,s)=>this.muxer.addVideoChunk(i,s),error:i=>this.failure=i instanceof Error?i:new Error(String(i))}),this.encoder.configure(e)}async add(e){let t=1e6/qo,i=new VideoFrame(e,{timestamp:this.count*t,duration:t});for(this.encoder.encode(i,{keyFrame:this.count%CE===0}),i.close(),this.count+=1;this.encoder.encodeQueueSize>RE&&!this.failure;)await new Promise(s=>setTimeout(s,4));if(this.failure)throw this.failure}async end(){if(await this.encoder.flush(),this.failure)throw this.failure;return this.encoder.close(),this.muxer.finalize(),new Blob([this.target.buffer],{type:"video/webm"})}};var DE=26,UE=1e3,FE=1e3/12,NE=300,kE=150,OE=document.body.dataset.source!==void 0,BE="This is a live stream: what has come since the page was opened. Displacements are rounded to 16 bits of what the points of a block moved. Contacts, stresses and bolts come less often than pictures where there are many: between two of their instants those of the earlier one are shown.",$o=document.body.dataset.source==="model";function Zd(n){let e=xe("trouble");e.textContent=`This page cannot be shown: ${n instanceof Error?n.message:String(n)}`,e.hidden=!1}function Gs(n){let e=getComputedStyle(document.documentElement).getPropertyValue(n).trim();return[1,3,5].map(t=>parseInt(e.slice(t,t+2),16))}var Jd=class{constructor(e){this.source=e;this.charts=[];this.rows=new Map;this.mesh=null;this.mesh_index=-1;this.frame=null;this.index=-1;this.note=null;this.wanted=0;this.loading=!1;this.playing=!1;this.clock=0;this.last_tick=0;this.still=0;this.fields=ws;this.field=ws[0];this.following=!1;this.slow_asked=!1;this.models_shown=0;this.detail_shown=null;this.pair=null;this.led=!1;this.events_shown=null;this.legend={what:"",ticks:[],names:[]};this.chosen=-1;this.scale_bar={pixels:0,text:""};this.labels=[];this.draw_asked=!1;this.own_view=!1;this.crosses=null;this.forces=null;this.most_bolt=0;this.most_slip=0;this.filming=!1;this.read_at=0;this.was_dense=!1;this.shown={original:!0,joints:!1,outline:!0,crosses:!1,water:!0,slip:!1,contacts:!1,bolts:!0,supports:!0,monitors:!0,chosen:!0,contact:!0};this.block_chart=null;this.block_history=null;this.held=e=>this.run.model.blocks[e]?.held??!1;this.area_of=new WeakMap;this.monitor_chart=null;this.ledger_chart=null;this.closure_chart=null;this.run=e.run,this.frames=this.run.frames.list,this.contact_box=new Ol(this.run,()=>this.redraw()),this.fields=e.live?zl:ws.filter(i=>i.id!=="joint"||this.run.contacts);let t=null;try{t=new Ch(xe("view"),this.run.model.blocks.length)}catch{Zd("this browser has no WebGL 2, which the animation needs; histories and tables are below")}this.scene=t}async start(){this.pair=Wl.find(e=>this.heard(e)),this.show_text(),this.fill_controls(),this.bind(),this.use_theme(),this.scene?.resize(),this.fit(),await this.go(this.source.live?this.frames.length-1:0),this.rows=await this.source.history(),this.make_charts(),this.redraw(),this.tell_extent(!0),this.source.live&&(this.set_following(!0),this.source.live.follow(e=>this.stream_changed(e),e=>this.tell(ig(e))),tg(e=>this.source.live.command(e)),this.show_stream()),document.body.dataset.ready="true"}tell_extent(e){let[t,i]=this.run.origin,[s,r,o,a]=this.run.frames.bounds;this.pair?.tell({ranges:this.run.frames.ranges,bounds:[s+t,r+i,o+t,a+i],...e?{hello:e}:{}})}heard(e){let[t,i]=this.run.origin,s=(r,o)=>{o!==void 0&&(xe(r).value=o)};if(e.ranges&&e.bounds){let r=this.run.frames,[o,a]=[r.bounds,e.bounds];r.ranges=Rg(r.ranges,e.ranges),r.bounds=[Math.min(o[0],a[0]-t),Math.min(o[1],a[1]-i),Math.max(o[2],a[2]-t),Math.max(o[3],a[3]-i)],this.update_colours(),e.hello&&this.tell_extent(!1)}s("field",e.field),s("range",e.range),s("factor",e.factor),e.field!==void 0&&this.use_choices(),(e.fit||e.bounds)&&this.fit(!0),e.view&&this.scene&&(this.own_view=!0,Object.assign(this.scene.view,{x:e.view[0]-t,y:e.view[1]-i,scale:e.view[2]}),this.redraw(!0,!0)),e.time!==void 0&&(this.play(!1),this.led=!0,this.go(this.index_at(e.time)))}use_choices(){let e=xe("field");this.field=this.fields.find(t=>t.id===e.value)??this.fields[0],xe("range").disabled=this.field.kind==="names",this.update_places(),this.update_colours(),this.redraw()}choices_changed(){this.use_choices(),this.ask_for_field();let e=t=>xe(t).value;this.pair?.tell({field:e("field"),range:e("range"),factor:e("factor")})}set_following(e){this.following=e,xe("follow").setAttribute("aria-pressed",String(e)),e&&this.go(this.frames.length-1)}ask_for_field(){let e=this.source.live;!e||!ir.includes(this.field)||this.newest_scalar()===this.field.id||(e.can_control()?e.command(`field ${this.field.id}`):(!this.mesh||!this.frame||!Zu(this.field,this.mesh,this.frame))&&this.tell(`The stream carries ${this.newest_scalar()}. It carries what this page asks for with scree run --live --control and scree view --live --control.`))}newest_scalar(){return this.frame?.scalar_field??""}show_stream(){let e=this.source.live;xe("control-box").hidden=!e.can_control(),ng(e.state())}stream_changed(e){if(this.show_stream(),e&&this.note){let t=this.frames.indexOf(this.note);this.index=this.wanted=t>=0?t:Math.min(this.index,this.frames.length-1)}xe("time").max=String(this.frames.length-1),this.source.live.models()!==this.models_shown&&this.use_model(),this.frame&&this.frame.stress!==this.detail_shown&&this.use_detail(this.frame),this.following&&this.go(this.frames.length-1),!this.slow_asked&&(this.slow_asked=!0,setTimeout(()=>{this.slow_asked=!1,this.refresh_texts()},UE))}use_model(){this.models_shown=this.source.live.models(),this.fill_blocks(),this.fill_layers(),this.use_theme(),this.mesh&&this.scene?.use_mesh(this.mesh,this.held),this.update_places(),this.update_colours(),this.redraw()}use_detail(e){this.detail_shown=e.stress,this.update_layers(),this.update_colours(),this.contact_box.show(e.contacts),this.redraw()}async refresh_texts(){this.show_subtitle(),Wu(this.run,xe("found")),this.events_shown!==this.run.events&&(this.events_shown=this.run.events,Xu(this.run,xe("events"),e=>this.go_to_time(e))),this.mark_stages(),this.rows=await this.source.history(),this.make_charts(),this.update_colours(),this.redraw(),this.chosen>=0&&this.follow_block(this.chosen)}show_subtitle(){let e=this.run,t=this.frames[this.frames.length-1];xe("title").textContent=e.title||"Scree run";let i=e.model.blocks.filter(r=>r.held).length,s=this.source.live?[this.source.live.status()]:$o?["before its run"]:[Gu(e),`${Xt(t.time,4)} s simulated`];xe("subtitle").textContent=[...this.pair?[e.folder]:[],...s,`${e.model.blocks.length} blocks${i>0?`, ${i} of them held`:""}`,`${e.stages.length} ${e.stages.length===1?"stage":"stages"}`,`Scree ${String(e.asked.version??"")}`].join(" \xB7 ")}show_text(){let e=this.run;this.show_subtitle();let t=this.frames.length;xe("thinning").textContent=this.source.live?BE:[$o?"This is the model before its run.":OE?`All ${t} stored frames are served as they are asked for; the range of colours is that of at most 300 of them.`:t<e.frames.stored?`${t} of the ${e.frames.stored} stored frames are in this file (scree report --size says how large it may be).`:`All ${t} stored frames are in this file.`,"Displacements have 17 significant bits, velocities and stresses 12. Stress is recovered at the corners of elements, as in scree snapshot.",e.history.whole?"":"Histories are thinned in time.",e.contacts?"Of the contact points, those that are closed are here.":"The run stored no contacts (output.contacts)."].join(" "),xe("licences").textContent=document.getElementById("scree-licences")?.textContent??"",$o?xe("found-box").hidden=xe("charts").hidden=xe("transport").hidden=!0:Wu(e,xe("found")),xe("asked-box").hidden=this.source.live!==void 0,xe("follow").hidden=this.source.live===void 0,xe("contact-box").hidden=!e.contacts,xe("film").hidden=$o,lg(e,xe("asked")),Xu(e,xe("events"),i=>this.go_to_time(i))}fill_blocks(){let e=xe("block");for(;e.options.length>1;)e.remove(1);for(let[t,i]of this.run.model.blocks.entries()){let s=Qe("option",i.name);s.value=String(t),e.append(s)}e.value=String(this.chosen)}fill_controls(){let e=(a,l,c)=>{let u=xe(a);for(let[h,f]of l){let d=Qe("option",f);d.value=h,u.append(d)}c!==void 0&&(u.value=c)};e("field",this.fields.map(a=>[a.id,a.label])),this.fill_blocks();let t=this.source.live!==void 0;e("monitor-quantity",zu.filter(a=>!t||!a.includes("stress")).map(a=>[a,a])),e("block-quantity",zu.filter(a=>!t||a!=="speed").map(a=>[a,a]));let i=this.frames[this.frames.length-1].time-this.frames[0].time,s=[.001,.01,.1,.25,.5,1,2,5,10,100,1e3],r=i>0?s.reduce((a,l)=>Math.abs(Math.log(l*10/i))<Math.abs(Math.log(a*10/i))?l:a,1):1;e("speed",s.map(a=>[String(a),a===1?"real time":`\xD7 ${a}`]),String(r)),this.fill_layers();let o=xe("time");o.max=String(this.frames.length-1),this.mark_stages()}fill_layers(){let e=this.source.live!==void 0,t=xe("layers");t.replaceChildren(...t.querySelectorAll(":scope > :not(label)"));let i=[["outline","outlines of the blocks"]];i.push(["original","original outline"]),i.push(["joints","joints as drawn"],["crosses","principal stress crosses"]),this.run.model.supports.length+(this.run.model.edges??[]).length>0&&i.push(["supports","supports"]),(e||this.run.history.monitors.some(r=>r.at))&&i.push(["monitors","monitors"]),(this.run.model.water??[]).length>0&&i.push(["water","water levels"]),this.run.bolts&&i.push(["bolts","bolts and their forces"]),this.run.contacts&&i.push(["contacts","contact forces and states"],["slip","slip of the joints"]);let s=this.run.model.joints.lines.length+this.run.model.joints.cracks.length>0;for(let[r,o]of i){if(r==="joints"&&!s)continue;let a=Qe("label"),l=Qe("input");l.type="checkbox",l.id=`layer-${r}`,l.checked=this.shown[r],l.addEventListener("change",()=>{this.shown[r]=l.checked,this.scene?.show(r,l.checked),this.update_layers(),this.update_marks(),this.redraw()}),a.append(l,` ${o}`),t.append(a)}}mark_stages(){let e=[];this.frames.forEach((i,s)=>{(s===0||i.stage!==this.frames[s-1].stage)&&e.push([s,i.stage])});let t=Math.max(1,this.frames.length-1);xe("stages").replaceChildren(),e.forEach(([i,s],r)=>{let o=Qe("span",s);o.title=s,o.style.left=`${100*i/t}%`,o.style.width=`${100*((e[r+1]?.[0]??t)-i)/t}%`,xe("stages").append(o)})}bind(){let e=(t,i,s)=>xe(t).addEventListener(i,s);e("play","click",()=>this.play(!this.playing)),e("follow","click",()=>(this.play(!1),this.set_following(!0))),e("back","click",()=>this.step(-1)),e("next","click",()=>this.step(1)),e("time","input",()=>this.seek(Number(xe("time").value))),e("zoom-in","click",()=>this.zoom(1.3)),e("zoom-out","click",()=>this.zoom(1/1.3)),e("fit","click",()=>this.fit()),e("save","click",()=>void this.save()),e("film","click",()=>void this.film()),e("contact-next","click",()=>this.contact_box.next(this.chosen)),e("theme","change",()=>$m(xe("theme").value));for(let t of["field","range","factor"])e(t,"change",()=>this.choices_changed());e("block","change",()=>this.choose(Number(xe("block").value))),e("monitor-quantity","change",()=>this.draw_monitors()),e("block-quantity","change",()=>this.draw_block()),e("ledger-sides","change",()=>this.draw_ledger()),document.addEventListener("keydown",t=>this.key(t)),Fl(()=>(this.use_theme(),this.redraw())),this.scene&&(new ResizeObserver(()=>{this.scene.resize(),this.own_view?this.redraw(!0,!0):this.fit()}).observe(xe("picture")),this.bind_pointer(xe("view"),this.scene))}bind_pointer(e,t){let i=new Map,s=0;e.addEventListener("pointerdown",o=>{e.setPointerCapture(o.pointerId),i.set(o.pointerId,[o.offsetX,o.offsetY]),s=0}),e.addEventListener("pointermove",o=>{let[a,l]=t.place(o.offsetX,o.offsetY);xe("pointer").textContent=`x = ${(a+this.run.origin[0]).toFixed(2)} m, y = ${(l+this.run.origin[1]).toFixed(2)} m`;let c=i.get(o.pointerId);if(!c)return;let[u,h]=[o.offsetX-c[0],o.offsetY-c[1]];if(s+=Math.abs(u)+Math.abs(h),i.size===2){let f=[...i].find(([_])=>_!==o.pointerId)[1],d=(_,v)=>Math.hypot(_-f[0],v-f[1]);t.zoom(d(o.offsetX,o.offsetY)/Math.max(1,d(...c)),f[0],f[1])}else s>3&&(t.view.x-=u/t.view.scale,t.view.y+=h/t.view.scale);i.set(o.pointerId,[o.offsetX,o.offsetY]),s>3&&(this.own_view=!0),this.redraw(!0)});let r=o=>i.delete(o.pointerId);e.addEventListener("pointercancel",r),e.addEventListener("pointerleave",()=>xe("pointer").textContent=""),e.addEventListener("pointerup",o=>{if(r(o),s<=3&&this.mesh){let[a,l]=t.place(o.offsetX,o.offsetY);if(this.contact_box.clicked(a,l,this.shown.contacts||this.shown.slip?t.view.scale:0))return;let c=xg(this.mesh,t.position,a,l);this.choose(c<0?-1:this.mesh.block[c]),c>=0&&xe("block-box").scrollIntoView({block:"nearest"})}}),e.addEventListener("wheel",o=>{o.preventDefault(),t.zoom(Math.exp(-o.deltaY*(o.deltaMode===1?.05:.0015)),o.offsetX,o.offsetY),this.own_view=!0,this.redraw(!0)},{passive:!1})}key(e){if(e.ctrlKey||e.metaKey||e.altKey)return;let t=e.target;if(t.closest("input, select, textarea, pre, summary, .scroll"))return;let i=t.id==="view",s=(l,c)=>{let u=this.scene.view;u.x+=l*40/u.scale,u.y+=c*40/u.scale,this.own_view=!0,this.redraw(!0)},r={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};if(i&&this.scene&&r[e.key]){s(...r[e.key]),e.preventDefault();return}let a={" ":()=>this.play(!this.playing),ArrowLeft:()=>this.step(-1),ArrowRight:()=>this.step(1),Home:()=>this.seek(0),End:()=>this.seek(this.frames.length-1),"+":()=>this.zoom(1.3),"=":()=>this.zoom(1.3),"-":()=>this.zoom(1/1.3),0:()=>this.fit(),s:()=>void this.save(),S:()=>void this.save(),v:()=>void this.film(),V:()=>void this.film(),c:()=>this.contact_box.next(this.chosen),C:()=>this.contact_box.next(this.chosen)}[e.key];!a||e.key===" "&&t.tagName==="BUTTON"||(e.preventDefault(),a())}step(e){this.seek(Math.min(this.frames.length-1,Math.max(0,this.wanted+e)))}seek(e){this.led=!1,this.play(!1),this.source.live&&this.set_following(!1),this.go(e).then(()=>this.say())}go_to_time(e){this.seek(this.index_at(e))}index_at(e){let t=0;return this.frames.forEach((i,s)=>{i.time<=e+1e-9&&(t=s)}),t}async go(e){if(this.wanted=e,!this.loading){this.loading=!0;try{for(;this.note!==this.frames[this.wanted];){let t=this.wanted,i=this.frames[t],[s,r]=await Promise.all([this.source.frame(t),this.source.mesh(i.mesh)]);this.mesh_index!==i.mesh&&(this.mesh=r,this.mesh_index=i.mesh,this.scene?.use_mesh(r,this.held),this.source.live&&this.scene&&this.show_original()),this.frame=s,this.index=Math.max(0,this.frames.indexOf(i)),this.note=i,this.update_places(),this.update_colours(),this.show_instant(),this.redraw(),this.led||this.pair?.tell({time:i.time})}}catch(t){this.play(!1),Zd(t)}finally{this.loading=!1}}}play(e){if(e===this.playing)return;e&&this.source.live&&this.set_following(!1),e&&(this.led=!1),this.playing=e;let t=xe("play");if(t.textContent=e?"Pause":"Play",t.setAttribute("aria-pressed",String(e)),!e)return this.index>=0&&this.show_instant(),this.say();this.wanted>=this.frames.length-1&&(this.wanted=0),this.clock=this.frames[this.wanted].time,this.last_tick=performance.now(),this.still=0;let i=s=>{if(!this.playing)return;let r=Math.min(250,Math.max(0,s-this.last_tick));this.last_tick=s,this.loading||this.advance(r),requestAnimationFrame(i)};requestAnimationFrame(i),this.go(this.wanted)}advance(e){let t=this.frames[this.wanted+1];if(!t)return this.play(!1);if(t.time<=this.frames[this.wanted].time){this.still+=e,this.still>=FE&&(this.still=0,this.go(this.wanted+1));return}this.clock+=e/1e3*Number(xe("speed").value);let i=this.wanted;for(;i+1<this.frames.length&&this.frames[i+1].time<=this.clock&&this.frames[i+1].time>this.frames[i].time;)++i;i!==this.wanted&&this.go(i);for(let s of[1,2])i+s<this.frames.length&&this.source.frame(i+s).catch(()=>{})}instant(){let e=this.frames[this.index];return`t = ${zn(e.time)}, ${e.stage}`}show_instant(){let e=this.frames[this.index];xe("instant").textContent=this.instant();let t=xe("time");t.value=String(this.index),t.setAttribute("aria-valuetext",`${zn(e.time)}, stage ${e.stage}, frame ${this.index+1} of ${this.frames.length}`),xe("view").setAttribute("aria-label",`The blocks at ${zn(e.time)} in stage ${e.stage}, coloured by ${this.field.label}`);let i=performance.now();if(!(this.playing&&i-this.read_at<kE)){this.read_at=i;for(let s of this.charts)s.at(e.time);this.show_block_facts(),this.contact_box.show(this.frame?.contacts??null)}}say(){this.index>=0&&(xe("said").textContent=this.instant())}use_theme(){if(this.scene?.use_theme({ground:Gs("--paper"),ink:Gs("--edge"),held:Gs("--held"),hatch:Gs("--hatch"),original:Gs("--original")}),!this.scene)return;this.show_original();let e=Tg(this.run);this.scene.use_lines("joints",e.ends,e.tint);for(let t of Object.keys(this.shown))this.scene.show(t,this.shown[t]);this.frame&&this.update_places()}show_original(){let e=Gs("--original");this.scene.use_original(this.source.live?this.scene.original_lines():Sg(this.run),e)}factor(){return Number(xe("factor").value)}update_places(){!this.scene||!this.frame||(this.scene.use_displacement(this.frame.displacement,this.factor()),this.scene.choose(this.chosen),this.update_layers())}update_layers(){if(!this.scene||!this.frame||!this.mesh)return;if(this.crosses=this.shown.crosses?yg(this.mesh,this.frame,this.scene.position,this.held,DE/this.scene.view.scale):null,this.crosses&&this.scene.use_lines("crosses",this.crosses.ends,this.crosses.tint),this.forces=null,this.shown.contacts&&this.frame.contacts){let[t,i,s,r]=this.run.frames.bounds;this.forces=bg(this.frame.contacts,.08*Math.hypot(s-t,r-i)),this.scene.use_lines("contacts",this.forces.ends,this.forces.tint)}let e=this.shown.bolts&&this.frame.bolts?Mg(this.frame.bolts):null;this.run.bolts&&this.scene.use_lines("bolts",e?.ends??new Float32Array(0),e?.tint??new Uint8Array(0)),this.most_bolt=e?.most??0,this.most_slip=this.shown.slip&&this.frame.contacts?tf(this.frame.contacts,1).most:0,this.show_layer_key()}update_marks(){if(!this.scene||this.index<0)return;let e=1/this.scene.view.scale,t=Eg(this.run,Gs("--mark"),11*e);this.scene.use_lines("supports",t.ends,t.tint);let i=wg(this.run,12*e);if(this.scene.use_lines("water",i.ends,i.tint),this.shown.slip&&this.frame?.contacts){let c=tf(this.frame.contacts,7*e);this.scene.use_lines("slip",c.ends,c.tint)}let s=nf(this.contact_box.place,[230,60,0],9*e);this.scene.use_lines("contact",s.ends,s.tint);let r=this.frames[this.index].time,o=[],a=[];this.labels=[],this.shown.monitors&&this.run.history.monitors.forEach((c,u)=>{let h=this.monitor_place(c.at,u,r);if(!h)return;o.push(h);let[f,d]=this.scene.pixel(...h),_=Qe("span",c.name);_.style.transform=`translate(${f+8}px, ${d-20}px)`,a.push(_),this.labels.push([c.name,f+12,d-11])}),xe("labels").replaceChildren(...a);let l=nf(o,Gs("--mark"),5*e);this.scene.use_lines("monitors",l.ends,l.tint)}monitor_place(e,t,i){let s=this.rows.get(`m${t}.time`),r=this.rows.get(`m${t}.u`);if(!e||!s||!r||s.length===0)return null;let[o,a]=[0,s.length-1];for(;o<a;){let l=o+a+1>>1;s[l]<=i*(1+1e-6)+1e-9?o=l:a=l-1}return[e[0]+this.factor()*r[2*o],e[1]+this.factor()*r[2*o+1]]}show_layer_key(){this.was_dense=this.scene?.dense??!1;let e=xe("layer-key");e.replaceChildren();let t=(i,s="")=>{let r=Qe("div");for(let[o,a]of i){let l=Qe("span",void 0,"swatch");l.style.background=Ms(o),r.append(l,`${a}  `)}r.append(s),e.append(r)};if(this.scene?.dense&&(this.shown.outline||this.shown.original)&&t([],"Outlines of blocks as small as here show when one zooms in."),this.run.model.blocks.some(i=>i.held)&&t([],"Hatched: held or driven as a whole."),this.shown.joints&&t(this.run.model.joints.laws.map((i,s)=>[jr(s+3),i.name])),this.crosses&&this.crosses.stress>0&&t([[Qu,"compression"],[ef,"tension"]],`\xB7 Longest arm: ${Zt(this.crosses.stress,"Pa",2)}.`),this.forces){let i=this.forces;t([[la,`sticking (${i.sticking})`],[ca,`slipping (${i.slipping})`],[ha,`slipping, strength failed (${i.failed})`]],i.force>0?`${this.of_when()}\xB7 Longest line: ${Zt(i.force,"N",2)} for 1 m of thickness.`:"\xB7 No forces.")}if(this.shown.slip&&this.run.contacts&&t([[jn("magnitude",0),"slip 0"],[jn("magnitude",1),`${Zt(this.most_slip,"m")} (largest now)`]]),this.shown.bolts&&this.run.bolts&&t([[jn("magnitude",0),"bolt force 0"],[jn("magnitude",1),`${Zt(this.most_bolt,"N")}/m (largest now)`]]),this.shown.water)for(let{joints:i}of this.run.model.water??[])t([[rr,`water in ${i.length===0?"all joints":i.map(s=>this.run.model.joints.laws[s]?.name).join(", ")}`]])}of_when(){let[e,t]=[this.note?.time,this.frame?.detail_time];return t===void 0||t===e?"":`at ${zn(t)} `}names(){return this.field.kind!=="names"?[]:this.field.names?this.field.names(this.run).map((e,t)=>[e,this.field.colours?.[t]??jr(t)]):Array.from({length:10},(e,t)=>["",jr(t)])}update_colours(){if(!this.scene||!this.frame||!this.mesh)return;let e=this.scene.values;cg(this.field,this.mesh,this.frame,e);let t=this.run.frames.ranges[this.field.id],i=xe("range").value==="run"&&t,s=this.field.kind==="names"?[0,1]:i?t:hg(this.field,this.mesh,e,this.held),r=this.names();this.scene.use_colours(this.field,s,r.map(([,o])=>o)),this.legend=Ag(this.field,s,r.filter(([o])=>o!=="")),ir.includes(this.field)&&this.frame.scalar_field!==this.field.id&&(this.legend.what+=Zu(this.field,this.mesh,this.frame)?this.of_when()&&`, ${this.of_when()}`:": not in this frame"),this.field.id==="joint"&&(this.legend.what+=": the worst of their contacts"),this.field.id==="block"&&(this.legend.what="block (neighbours differ in colour; the list below has the names)"),Cg(xe("legend"),this.field,this.legend),xe("view").setAttribute("aria-label",`The blocks at ${zn(this.frames[this.index].time)} in stage ${this.frames[this.index].stage}, coloured by ${this.field.label}`)}redraw(e=!1,t=!1){if(e&&this.own_view&&!t&&this.scene){let{x:i,y:s,scale:r}=this.scene.view;this.pair?.tell({view:[i+this.run.origin[0],s+this.run.origin[1],r]})}e&&this.shown.crosses?this.update_layers():this.scene&&this.scene.dense!==this.was_dense&&this.show_layer_key(),!(this.draw_asked||!this.scene)&&(this.draw_asked=!0,requestAnimationFrame(()=>{this.draw_asked=!1,this.update_marks(),this.scene.render(),this.show_scale()}))}show_scale(){let e=this.scene.view.scale,t=Zm(140/e),i=tr("m",t);this.scale_bar={pixels:t*e,text:t>=1e3?`${t/1e3} km`:`${Number((t/i.factor).toPrecision(3))} ${i.name}`},xe("scale-bar").style.width=`${this.scale_bar.pixels}px`,xe("scale-text").textContent=this.scale_bar.text}fit(e=!1){!e&&this.own_view&&this.pair?.tell({fit:!0}),this.own_view=!1,this.scene?.fit(...this.run.frames.bounds),this.redraw(!0)}zoom(e){this.own_view=!0,this.scene?.zoom(e,.5*this.scene.width,.5*this.scene.height),this.redraw(!0)}picture_text(){return{title:this.run.title||"Scree run",instant:this.instant(),scale:this.scale_bar,field:this.field,legend:this.legend,dark:Ul(),labels:this.labels}}hand_out(e,t){let i=Qe("a");i.href=URL.createObjectURL(e),i.download=`${this.run.folder||"scree"}-${this.field.id}-${t}`,i.click(),setTimeout(()=>URL.revokeObjectURL(i.href),1e4)}async save(){this.scene&&(this.scene.render(),this.hand_out(await Ig(sf(this.scene.canvas,this.picture_text())),`${this.frames[this.index].time.toFixed(3)}s.png`))}async film(){if(this.filming){this.filming=!1;return}if(!this.scene)return;this.play(!1),this.source.live&&this.set_following(!1);let e=this.index;this.filming=!0;let t=xe("film");t.setAttribute("aria-pressed","true");try{let i=await $_(this.film_steps(),(s,r)=>this.film_picture(s,r),s=>(t.textContent=`Stop (${Math.round(100*s)} %)`,this.filming));this.hand_out(i,"film.webm"),this.tell("The film is saved.")}catch(i){this.tell(`The film cannot be made: ${i instanceof Error?i.message:String(i)}`)}finally{this.filming=!1,t.textContent="Film",t.setAttribute("aria-pressed","false"),this.go(e)}}async film_picture(e,t){e!==this.index&&await this.go(e),this.update_marks(),this.scene.render(),sf(this.scene.canvas,this.picture_text(),t)}film_steps(){let[e,t]=[this.frames[0].time,this.frames[this.frames.length-1].time];return q_(e,t,Number(xe("speed").value)).map(i=>this.index_at(i))}tell(e){xe("said").textContent=e,xe("note").textContent=e,xe("note").hidden=!1,setTimeout(()=>xe("note").hidden=!0,6e3)}choose(e){this.chosen=e,xe("block").value=String(e),this.scene?.choose(e),this.redraw(),this.show_block_facts(),xe("block-figure").hidden=e<0,e>=0&&!$o&&this.follow_block(e)}block_mean(e,t,i,s){let r=new Float64Array(7),o=0;for(let a=0;a<s.length;++a){if(e.block[a]!==i)continue;let l=e.offsets[a],c=e.offsets[a+1],u=s[a]/(c-l);o+=s[a];for(let h=l;h<c;++h){let f=e.cells[h];for(let d of[0,1])r[d]+=u*t.displacement[2*f+d],r[2+d]+=u*t.velocity[2*f+d];for(let d of[0,1,2])r[4+d]+=u*t.stress[3*f+d]}}return o>0?Array.from(r,a=>a/o):null}show_block_facts(){let e=xe("block-facts"),t=this.run.model.blocks[this.chosen];if(!t||!this.mesh||!this.frame)return e.replaceChildren();let i=this.mesh.block.indexOf(this.chosen),s=i<0?null:this.block_mean(this.mesh,this.frame,this.chosen,this.areas(this.mesh)),r=t.rings.length>0?this.ring_area(t.rings):this.areas(this.mesh).reduce((a,l,c)=>this.mesh.block[c]===this.chosen?a+l:a,0),o=[["Material",this.run.model.materials[t.material]?.name],["Area",`${Xt(r)} m\xB2`],["Held",t.held?"yes":void 0]];if(s&&i>=0){let a=Math.hypot(.5*(s[4]-s[5]),s[6]),l=.5*(s[4]+s[5]);o.push(["Method",`${(this.run.model.methods[this.mesh.method[i]]??"").toUpperCase()}${this.frame.integrator.length===0?"":this.frame.integrator[i]===0?", explicit":", implicit"}`],["Displacement",`${Zt(Math.hypot(s[0],s[1]),"m")} (${Zt(s[0],"m")}, ${Zt(s[1],"m")})`]),this.source.live||o.push(["Speed",Zt(Math.hypot(s[2],s[3]),"m/s")]),this.frame.stress.length>0&&o.push(["Mean \u03C3\u2081, \u03C3\u2083",`${Zt(l+a,"Pa")}, ${Zt(l-a,"Pa")}`]);let c=this.frame.contacts;if(c){let u=0;for(let h=0;h<c.state.length;++h)(c.blocks[3*h]===this.chosen||c.blocks[3*h+1]===this.chosen)&&(u+=1);o.push(["Closed contacts",String(u)])}}nr(e,o)}areas(e){let t=this.area_of.get(e);return t||this.area_of.set(e,t=Gl(e)),t}ring_area(e){return e.map(i=>{let s=0;for(let r=0;r<i.length;r+=2){let o=(r+2)%i.length;s+=i[r]*i[o+1]-i[o]*i[r+1]}return Math.abs(.5*s)}).reduce((i,s,r)=>r===0?s:i-s,0)}async follow_block(e){let t=[],i=[],s=this.source.live?Math.ceil(this.frames.length/NE):1;for(let r=0;r<this.frames.length&&this.chosen===e;r+=s){let o=this.frames[r],[a,l]=await Promise.all([this.source.frame(r),this.source.mesh(o.mesh)]),c=this.block_mean(l,a,e,this.areas(l));c&&(t.push(o.time),i.push(c))}this.chosen===e&&(this.block_history={block:e,time:Float64Array.from(t),rows:i.map(r=>Float64Array.from(r))},this.draw_block())}draw_block(){let e=this.block_history;if(!e||e.block!==this.chosen)return;this.block_chart||this.charts.push(this.block_chart=this.chart("block-chart",220)),xe("block-title").textContent=`Block ${this.run.model.blocks[e.block].name}`;let t=xe("block-quantity").value,i=(a,l)=>.5*(a[4]+a[5])+l*Math.hypot(.5*(a[4]-a[5]),a[6]),s={displacement:a=>Math.hypot(a[0],a[1]),"horizontal displacement":a=>a[0],"vertical displacement":a=>a[1],speed:a=>Math.hypot(a[2],a[3]),"principal stress \u03C3\u2081":a=>i(a,1),"principal stress \u03C3\u2083":a=>i(a,-1)},r=t.includes("stress")?"Pa":t==="speed"?"m/s":"m",o=[{label:`mean ${t}`,values:e.rows.map(s[t])}];this.block_chart.draw({what:t,unit:r},e.time,o),this.block_chart.at(this.frames[this.index].time)}chart(e,t){return new Nl(xe(e),t,this.run.stages,i=>this.go_to_time(i))}make_charts(){if($o)return;xe("monitor-figure").hidden=this.run.history.monitors.length===0,this.run.history.monitors.length>0&&(this.monitor_chart||this.charts.push(this.monitor_chart=this.chart("monitor-chart",240)),this.draw_monitors()),this.ledger_chart||this.charts.push(this.ledger_chart=this.chart("energy-chart",240)),this.draw_ledger();let e=Km(this.rows);e.some(t=>t>0)?(this.closure_chart||this.charts.push(this.closure_chart=this.chart("closure-chart",200)),this.closure_chart.draw({what:"|closure| / moved",unit:"",log:!0},this.rows.get("l.time"),[{label:"closure",values:e}])):xe("closure-chart").textContent="Zero at every stored time.";for(let t of this.charts)t.at(this.frames[this.index].time)}draw_monitors(){let e=xe("monitor-quantity").value,{time:t,series:i,unit:s}=jm(this.run,this.rows,e);this.monitor_chart?.draw({what:e,unit:s},t,i),this.describe("monitor-chart",`Histories of the monitors, ${e}`,i,s)}draw_ledger(){let e=xe("ledger-sides").value.split(" "),t=Jm(this.run,this.rows,e);this.ledger_chart?.draw({what:"energy",unit:"J"},this.rows.get("l.time")??[],t),this.describe("energy-chart","Energy ledger over time",t,"J")}describe(e,t,i,s){let r=i.map(o=>`${o.label} ${Zt(o.values[o.values.length-1]??NaN,s)}`);xe(e).setAttribute("aria-label",`${t}. At the end: ${r.join("; ")}`)}};async function zE(){let n=document.body.dataset.source;return n===void 0?new Rh:n!=="live"?Ph.open():await Ih.open(t=>xe("subtitle").textContent=t)}zE().then(n=>new Jd(n).start()).catch(Zd);})();
